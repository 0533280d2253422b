// Defaults of pack-generate.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/standard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/text/text.h"
#include "dem/contact/thesis_soil.h"
#include "dem/run/scenario.h"
#include "dem/state/bodies.h"
#include "packing/generate/cloud.h"

namespace soilweave::packing {
namespace {

// Half of the last digit of the thesis's stiffness, N m/rad.
constexpr double last_digit = 0.005;
// Rate of the thesis's grains of scaled density, 1/s, at which the packings of its studies were made.
constexpr double thesis_rate = 1;
// Solid volume per grain, m3, of the thesis's representative volume of 1000 grains: 46.2202 x 46.1205 x 92.1203 mm at a
// void ratio of 0.6798.
constexpr double thesis_solids = 1.169e-7;
// Void ratios that compacted grains may reach, if none is asked for.
constexpr double densest_spheres = 0.5, densest_disks = 0.1, loose_spheres = 0.7, loose_disks = 0.2;
// Largest number of grains chosen by default: a packing of them takes minutes.
constexpr std::size_t most_chosen = 20'000;
// Largest number of grains in a remedy: what a machine of today holds.
constexpr std::size_t most_named = 3'000'000;
// Width of a cell, over its largest grain, below which a compaction stops.
constexpr double narrowest = 1 / 0.495;

// Returns (R/R0)^3, and exactly 1 if 0.13 N m/rad keeps its two digits.
double cube_ratio(double mean_radius) {
  const double ratio = std::pow(mean_radius / dem::thesis_radius, 3);
  return std::abs(ratio - 1) < last_digit / dem::thesis_rotational_stiffness ? 1 : ratio;
}

}  // namespace

double mean_radius(const io::Snapshot& state) {
  double sum = 0;
  for (const double r : state.grains.radius) sum += r;
  return sum / static_cast<double>(state.grains.size());
}

double default_rotational_stiffness(double mean_radius) {
  return dem::thesis_rotational_stiffness * cube_ratio(mean_radius);
}

double default_rate(double mean_radius) { return thesis_rate / std::cbrt(cube_ratio(mean_radius)); }

std::string default_material(double mean_radius) {
  return fmt::format(
      "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = \"4 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 29\n"
      "[contact.rolling]\nstiffness = {0}\nlimit = \"none\"\n[contact.twisting]\nstiffness = {0}\nlimit = \"none\"\n",
      default_rotational_stiffness(mean_radius));
}

std::vector<double> grain_radii(const Room& room, std::size_t n, const GrainSize& size) {
  std::vector<double> radii = room.curve.radii(n, room.dimension);
  const auto grains = static_cast<double>(n);
  double factor = 1;
  if (size.mean_radius) {
    double sum = 0;
    for (const double r : radii) sum += r;
    factor = *size.mean_radius * grains / sum;
  } else if (size.as_thesis) {
    double cubes = 0;
    for (const double r : radii) cubes += r * r * r;
    factor = std::cbrt(thesis_solids * grains / (4.0 / 3.0 * std::numbers::pi * cubes));
  }
  for (double& r : radii) r *= factor;
  return radii;
}

io::Snapshot new_cloud(const Room& room, std::size_t n, const GrainSize& size, std::optional<double> void_ratio,
                       double density, std::uint64_t seed) {
  if (void_ratio) room.at(*void_ratio).demand(n);
  room.demand(n);
  return cloud(grain_radii(room, n, size), room.void_ratio, room.proportions, room.dimension, density, seed);
}

std::size_t enough_grains(const Room& room, std::optional<double> void_ratio, std::size_t least) {
  const Room dense = room.at(room.dimension == 2 ? densest_disks : densest_spheres);
  // A void ratio above that of loose grains at rest does not widen the compacted cell.
  const double loose = room.dimension == 2 ? loose_disks : loose_spheres;
  if (room.at(std::min(void_ratio.value_or(dense.void_ratio), loose)).diameters(least) >= narrowest) return least;
  return dense.fewest(chosen_diameters, most_chosen).value_or(least);
}

Contacts::Contacts(std::string_view text, const std::string& name) {
  Settings document = Settings::parse(text, name);
  read(document);
}

void Contacts::read(Settings& document) {
  model = dem::read_model(document);
  density = dem::read_density(document);
  numerics = dem::read_numerics(document);
  document.finish();
  resolved = document.resolved();
}

std::vector<Key> Contacts::keys() {
  return keys_of([](Settings& document) { Contacts().read(document); });
}

double Room::diameters(std::size_t grains) const {
  const std::vector<double> radii = curve.radii(grains, dimension);
  double solids = 0, shape = 1;
  for (const double r : radii) solids += dem::grain_volume(dimension, r);
  for (int a = 0; a < dimension; ++a) shape *= proportions[a];
  const double width = std::pow(solids * (1 + void_ratio) / shape, 1.0 / dimension);
  return proportions.head(dimension).minCoeff() * width / (2 * radii.front());
}

std::optional<std::size_t> Room::fewest(double wanted, std::size_t most) const {
  std::size_t low = 1, high = 10;
  while (diameters(high) < wanted) {
    if (high >= most) return std::nullopt;
    low = high, high = std::min(most, 2 * high);
  }
  while (high - low > std::max<std::size_t>(1, high / 50)) {
    const std::size_t middle = (low + high) / 2;
    (diameters(middle) < wanted ? low : high) = middle;
  }
  return std::min(most, static_cast<std::size_t>(rounded_up(static_cast<double>(high))));
}

std::optional<double> Room::coarsest(double wanted, std::size_t grains) const {
  const auto wide = [&](double diameter) {
    return Room{curve.up_to(diameter), dimension, proportions, void_ratio}.diameters(grains) >= wanted;
  };
  double low = 1.01 * curve.diameter.front(), high = curve.diameter.back();
  if (low >= high || !wide(low)) return std::nullopt;
  while (high / low > 1.005) {
    const double middle = std::sqrt(low * high);
    (wide(middle) ? low : high) = middle;
  }
  return std::max(rounded_down(low), 1.01 * curve.diameter.front());
}

void Room::demand(std::size_t grains) const {
  const double now = diameters(grains);
  if (now < narrowest) refuse(grains, now);
}

void Room::refuse(std::size_t grains, double now) const {
  // A cell that is still closing must be wide enough at its end.
  const double loose = dimension == 2 ? loose_disks : loose_spheres;
  const Room end = at(void_ratio > loose ? (dimension == 2 ? densest_disks : densest_spheres) : void_ratio);
  std::string remedy;
  if (const auto cutoff = end.coarsest(chosen_diameters, grains))
    remedy = fmt::format("leave out grains coarser than {0:.4g} mm (--coarsest {0:.4g}mm)", 1e3 * *cutoff);
  if (const auto more = end.fewest(chosen_diameters, most_named))
    remedy += fmt::format("{}take at least {} grains (--grains)", remedy.empty() ? "" : ", or ", *more);
  if (remedy.empty()) remedy = "take a narrower grading or a more even cell (--aspect 1)";
  throw DataError(
      fmt::format("the cell of {} grains is {:.3g} diameters of the largest grain wide at a void ratio of {:.4g}, not "
                  "less than half "
                  "the cell: at least {} are needed; {}",
                  grains, now, void_ratio, least_diameters, remedy));
}

}  // namespace soilweave::packing
