// Doubts about a packing that was made all the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/doubtful.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/doubts/input_doubts.h"
#include "analysis/doubts/material_doubts.h"
#include "analysis/measure/fabric.h"
#include "analysis/measure/soundness.h"
#include "analysis/measure/stress.h"
#include "analysis/measure/tessellation.h"
#include "analysis/measure/volume_of_interest.h"

namespace soilweave::packing {
namespace {

constexpr analysis::SoundLimits limits = analysis::made_packing;
constexpr double most_overlap = 0.05;                         // mean overlap over the mean radius
constexpr double least_pressure = 500;                        // Pa, that of sand under 3 cm of sand
constexpr double median_error = 0.1;                          // share of the median diameter by mass
constexpr double most_left_out = 0.1;                         // share of the mass finer than a grading's first point
constexpr double finest_silt = 0.002, largest_cobbles = 200;  // mm, ISO 14688-1
constexpr double largest_radius = 0.09;                       // m, mean, near that of the largest cobbles
constexpr double loosest = 10;                                // void ratio of a cloud, beyond which units differ
constexpr std::size_t most_counted = 1'000'000;               // largest number of grains in a remedy

// Returns the median diameter by mass of n grains over that of the curve.
double median_ratio(const Room& room, std::size_t grains) {
  const std::vector<double> radii = room.curve.radii(grains, room.dimension);
  double total = 0, coarser = 0;
  for (const double r : radii) total += std::pow(r, room.dimension);
  for (const double r : radii)
    if ((coarser += std::pow(r, room.dimension)) >= 0.5 * total) return 2 * r / room.curve.quantile(0.5);
  return 0;
}

void doubt_stress(const io::Snapshot& state, std::vector<Doubt>& doubts) {
  const double ratio = analysis::stress_obliquity(state);
  if (!(ratio <= limits.obliquity))
    doubts.push_back(
        {"obliquity", fmt::format("q/p is {:.2g} in a state that should be isotropic, above {:.2g}: take more "
                                  "grains (--grains)",
                                  ratio, limits.obliquity)});
}

void doubt_cell(const io::Snapshot& state, std::vector<Doubt>& doubts) {
  const int d = state.grains.dimension;
  const double ratio = analysis::cell_over_grain(state).head(d).minCoeff();
  if (ratio >= limits.cell) return;
  const double more = 1.05 * static_cast<double>(state.grains.size()) * std::pow(limits.cell / ratio, d);
  doubts.push_back(
      {"cell",
       fmt::format(
           "the cell is {:.3g} diameters of the largest grain wide, below {}: take about {:.0f} grains (--grains)",
           ratio, limits.cell, more)});
}

// A number without a unit is read as Pa.
void doubt_pressure(const io::Snapshot& state, std::vector<Doubt>& doubts) {
  if (state.grains.dimension != 3) return;
  const double pressure = mean(analysis::cell_stress(state), 3);
  if (pressure >= least_pressure) return;
  doubts.push_back({"pressure", fmt::format("the packing bears {0:.3g} Pa: if {0:.3g} kPa was meant, write "
                                            "--pressure {0:.3g}kPa",
                                            pressure)});
}

}  // namespace

std::optional<Doubt> grading_doubt(const Room& room, std::size_t grains) {
  const double ratio = median_ratio(room, grains);
  if (std::abs(ratio - 1) <= median_error) return std::nullopt;
  std::size_t more = grains;
  while (std::abs(median_ratio(room, more) - 1) > median_error && more < most_counted) more = more * 3 / 2;
  const std::string remedy = more < most_counted
                                 ? fmt::format("take {} (--grains), or a curve without its finest sizes", more)
                                 : std::string("take a curve without its finest sizes");
  return Doubt{"grading",
               fmt::format("half the mass of the {} grains is finer than {:.3g} times the diameter that the grading "
                           "has there: {}",
                           grains, ratio, remedy)};
}

std::optional<Doubt> finest_doubt(const Grading& curve) {
  if (curve.left_out().empty() || curve.finer.front() <= most_left_out) return std::nullopt;
  return Doubt{"finest", fmt::format("{}: give the rows of the grading that are finer, down to {:.0f} % or less",
                                     curve.left_out(), 100 * most_left_out)};
}

std::optional<Doubt> size_doubt(const Grading& curve) {
  const double median = 1e3 * curve.quantile(0.5);
  if (median >= finest_silt && median <= largest_cobbles) return std::nullopt;
  return Doubt{"size",
               fmt::format("the median diameter of the grading is {:.3g} mm, where silt to cobbles have {:g} to {:g} "
                           "mm: check the unit of the column diameter",
                           median, finest_silt, largest_cobbles)};
}

std::optional<Doubt> coarsest_doubt(const Grading& curve, double coarsest) {
  if (coarsest <= curve.diameter.back()) return std::nullopt;
  return Doubt{"coarsest",
               fmt::format("--coarsest leaves nothing out: it is {:.4g} mm, and the largest diameter of the "
                           "grading is {:.4g} mm: give it in m, or with its unit (0.15mm)",
                           1e3 * coarsest, 1e3 * curve.diameter.back())};
}

std::optional<Doubt> radius_doubt(const io::Snapshot& state) {
  const double radius = mean_radius(state);
  if (radius < largest_radius) return std::nullopt;
  return Doubt{"size", fmt::format("the mean radius of the grains is {0:.4g} m, that of boulders: if {0:.4g} mm is "
                                   "meant, give it its unit (--mean-radius {0:.4g}mm, or a column radius [mm])",
                                   radius)};
}

std::optional<Doubt> length_doubt(const io::Snapshot& state) {
  if (!analysis::is_periodic(state)) return radius_doubt(state);
  const double void_ratio = analysis::void_ratio(state);
  if (void_ratio <= loosest) return radius_doubt(state);
  return Doubt{"cell-unit",
               fmt::format("the void ratio is {:.3g}, above {}: the cell is {:.4g} m wide, and the grains' "
                           "mean radius is {:.4g} m: check that both have one unit of length",
                           void_ratio, loosest, state.cell.matrix(0, 0), mean_radius(state))};
}

std::vector<Doubt> doubts_as_is(const io::Snapshot& state, const Contacts& contacts) {
  return analysis::material_doubts(state, contacts.model, contacts.numerics.gravity);
}

std::vector<Doubt> doubts_about(const io::Snapshot& state, const Contacts& contacts, const std::optional<Room>& room,
                                double unbalanced) {
  std::vector<Doubt> doubts = doubts_as_is(state, contacts);
  if (auto doubt = radius_doubt(state)) doubts.push_back(*doubt);
  if (auto doubt = room ? grading_doubt(*room, state.grains.size()) : std::nullopt) doubts.push_back(*doubt);
  for (Doubt& doubt : analysis::tolerance_doubts("--tolerance", unbalanced)) doubts.push_back(std::move(doubt));
  const analysis::Coordination c = analysis::coordination(state);
  const double rattlers = analysis::rattler_share(state, c.rattlers);
  if (rattlers > limits.rattlers)
    doubts.push_back(
        {"rattlers",
         fmt::format("{:.0f} % of the grains are rattlers, above {:.0f} %: small grains lie loose in "
                     "the voids of large ones; leave the finest sizes out, or count the grains that bear load",
                     100 * rattlers, 100 * limits.rattlers)});
  if (c.all < limits.coordination)
    doubts.push_back(
        {"coordination",
         fmt::format("the coordination number is {:.2f}, below {}: {} among the grains that "
                     "bear load; a higher pressure or a lower void ratio raises it",
                     c.all, limits.coordination, std::isnan(c.backbone) ? "none" : fmt::format("{:.2f}", c.backbone))});
  doubt_cell(state, doubts);
  doubt_stress(state, doubts);
  doubt_pressure(state, doubts);
  double overlap = 0;
  for (const double u : state.contacts.overlap) overlap += u / static_cast<double>(state.contacts.size());
  if (const double share = overlap / mean_radius(state); share > most_overlap)
    doubts.push_back(
        {"overlap", fmt::format("grains overlap by {:.2g} of their mean radius on average, above {}: contact laws "
                                "hold for small overlaps; a lower pressure or stiffer grains keep them so",
                                share, most_overlap)});
  return doubts;
}

}  // namespace soilweave::packing
