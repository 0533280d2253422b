// Doubts about analytical answers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace soilweave::gws {
namespace {

// Relative tolerance at the ends of a range, because numbers of data are rounded.
constexpr double slack = 0.01;

// Bags of one height over width were simulated, and cells under up to 100 kPa (thesis sections 5.1 and 5.2).
constexpr double tested_slenderness = 0.2;
constexpr Span tested_lateral{0, 1e5};
// Factor on the height over width up to which a bag counts as the shape that was simulated.
constexpr double like_shape = 2;

// Returns the values that leave a range as one phrase; empty if none does, or if the range is not known.
std::string beyond(const Span& range, const std::vector<double>& values, const char* name, double unit,
                   const char* unit_name, const char* basis = "identified on") {
  if (!range.known()) return "";
  double worst = 0, farthest = 0;
  for (const double v : values) {
    const double over = std::max(v - range.high * (1 + slack), range.low * (1 - slack) - v);
    if (std::isfinite(v) && over > farthest) farthest = over, worst = v;
  }
  if (farthest == 0) return "";
  return fmt::format("{} {:.4g}{} ({} {:.4g} to {:.4g}{})", name, worst / unit, unit_name, basis, range.low / unit,
                     range.high / unit, unit_name);
}

// Returns the phrases that are not empty, with commas between them.
std::string listed(const std::vector<std::string>& phrases) {
  std::string all;
  for (const std::string& phrase : phrases)
    if (!phrase.empty()) all += (all.empty() ? "" : ", ") + phrase;
  return all;
}

// Returns the greatest lateral stress outside the bag at any surcharge, Pa.
double greatest(const LateralStress& lateral) {
  return lateral.lateral.empty() ? 0 : *std::max_element(lateral.lateral.begin(), lateral.lateral.end());
}

}  // namespace

std::vector<Doubt> beyond_history(const LateralStress& lateral, double from, double to) {
  const std::vector<double>&history = lateral.surcharge, &stress = lateral.lateral;
  std::vector<Doubt> found;
  // A stress at a surcharge of 0 alone is a constant one.
  if (history.empty() || !(history.back() > 0)) return found;
  if (from < history.front() * (1 - slack))
    found.push_back(
        {"history-begin",
         fmt::format("the history of the lateral stress begins at a surcharge of {:.4g} kPa, and its first value, "
                     "{:.4g} kPa, is taken from {:.4g} kPa on; give rows from 0 kPa on",
                     history.front() / 1e3, stress.front() / 1e3, from / 1e3)});
  if (to > history.back())
    found.push_back({"history-end", fmt::format("the history of the lateral stress ends at a surcharge of {:.4g} kPa, "
                                                "and its last value, {:.4g} kPa, is kept up to {:.4g} kPa; give rows "
                                                "up to there",
                                                history.back() / 1e3, stress.back() / 1e3, to / 1e3)});
  return found;
}

std::vector<Doubt> doubts(const SoilFile& soil, bool chosen, const Case& asked, const std::vector<double>& stiffnesses,
                          const std::vector<Point>& states) {
  std::vector<Doubt> found;
  if (!chosen)
    found.push_back(
        {"default-soil", fmt::format("the soil is {}, since none was chosen: give --soil, of data/soils or identified "
                                     "from bags of your own (gws-solve identify --toml)",
                                     soil.name)});
  if (!soil.estimated.empty())
    found.push_back(
        {"estimated-soil", fmt::format("soil {}: {}; beta, n, m, xi, Poisson's ratio and the dilatancy line are "
                                       "Toyoura sand's; identify them on bags of its own (gws-solve identify)",
                                       soil.name, soil.estimated)});
  found.insert(found.end(), soil.doubts.begin(), soil.doubts.end());
  const Identified& range = soil.identified;
  if (soil.estimated.empty() && !(range.stiffness.known() && range.mean_stress.known() && range.axial_strain.known()))
    found.push_back({"unknown-range",
                     fmt::format("soil {} lacks [identified] with stiffness, mean_stress and axial_strain, the ranges "
                                 "of its data: extrapolation cannot be noticed",
                                 soil.name)});
  for (const Doubt& doubt : unscattered(soil)) found.push_back(doubt);
  std::vector<double> pressures, strains;
  for (const Point& point : states) {
    if (point.soil.end != End::none) continue;
    pressures.push_back(point.soil.p), strains.push_back(point.soil.strain_axial / 100);
  }
  if (std::string all =
          listed({beyond(soil.identified.stiffness, stiffnesses, "stiffness of the geotextile", 1e3, " kN/m"),
                  beyond(soil.identified.mean_stress, pressures, "mean stress", 1e3, " kPa"),
                  beyond(soil.identified.axial_strain, strains, "axial strain", 0.01, " %")});
      !all.empty())
    found.push_back(
        {"extrapolation", fmt::format("the constants of {} are extrapolated: {}; identify them on such bags "
                                      "(gws-solve identify)",
                                      soil.name, all)});
  const double slenderness = asked.bag.height / asked.bag.width;
  const bool like = slenderness * like_shape >= tested_slenderness && slenderness <= tested_slenderness * like_shape;
  const std::string shape =
      like ? "" : fmt::format("height over width {:.4g} (simulated bags had {:.4g})", slenderness, tested_slenderness);
  if (std::string all = listed(
          {shape, beyond(tested_lateral, {greatest(asked.lateral)}, "lateral stress", 1e3, " kPa", "simulated under")});
      !all.empty())
    found.push_back({"untested", fmt::format("the solution is untested here: {}; simulate such a bag "
                                             "(filter-expand, run-dem) before relying on it",
                                             all)});
  if (!states.empty()) {
    const auto [first, last] = std::ranges::minmax(states, {}, &Point::surcharge);
    for (Doubt& doubt : beyond_history(asked.lateral, first.surcharge, last.surcharge))
      found.push_back(std::move(doubt));
  }
  if (!states.empty() && states.back().soil.end == End::none && states.back().hoop_tension < 0)
    found.push_back(
        {"compressed",
         fmt::format("at {:.4g} kPa the lateral stress outside, {:.4g} kPa, exceeds the soil's, {:.4g} kPa: the "
                     "solution compresses the geotextile there, and no geotextile carries compression",
                     states.back().surcharge / 1e3, states.back().lateral / 1e3,
                     states.back().soil.lateral_stress() / 1e3)});
  return found;
}

std::vector<Doubt> unscattered(const SoilFile& soil) {
  if (soil.exact.empty()) return {};
  return {
      {"exact-fit",
       fmt::format(
           "{}: fitted to as many points as constants, so the scatter from point to point is unknown, and "
           "intervals and bands do not include it; give more points (strengths at three pressures, three geotextiles)",
           listed(soil.exact))}};
}

std::vector<Doubt> contradictions(const Geotextile& geotextile) {
  // Curves of data sheets bend: stiffness times failure strain may differ from the strength by a factor of 1.5.
  constexpr double factor = 1.5;
  const double at_failure = geotextile.stiffness * geotextile.failure_strain, strength = geotextile.strength;
  if (geotextile.curve.known() || !(strength > 0) || !(at_failure > 0)) return {};
  if (std::max(strength / at_failure, at_failure / strength) <= factor) return {};
  return {
      {"contradiction",
       fmt::format("geotextile {}: {:.4g} kN/m at a failure strain of {:.4g} % are {:.4g} kN/m, not its strength of "
                   "{:.4g} kN/m: the lesser of both counts; correct one of the three",
                   geotextile.name, geotextile.stiffness / 1e3, 100 * geotextile.failure_strain, at_failure / 1e3,
                   strength / 1e3)}};
}

}  // namespace soilweave::gws
