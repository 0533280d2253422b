// Doubts about tables of a scenario that its packing does not use, and about values in another unit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/doubts/input_doubts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>

namespace soilweave::analysis {
namespace {

// Strengths of geotextiles and geogrids, N/m. The lightest nonwovens have 4 kN/m, the heaviest geogrids 2000 kN/m.
constexpr double weakest = 3e3, strongest = 3e6;
// Largest ratio of the spacing of yarns to the width that a curve is of. Faces and sides of a bag differ in their
// spacing.
constexpr double farthest_width = 1.5;
// Largest share of the forces or stresses that a station at rest may be off.
constexpr double most_off = 0.1;

// Returns the numbers from `first` to below `count` that no list names.
std::vector<std::size_t> unnamed(std::size_t first, std::size_t count,
                                 const std::vector<const std::vector<std::int32_t>*>& lists) {
  std::vector<std::size_t> numbers;
  for (std::size_t n = first; n < count; ++n)
    if (std::ranges::none_of(lists, [&](const auto* list) {
          return std::ranges::find(*list, static_cast<std::int32_t>(n)) != list->end();
        }))
      numbers.push_back(n);
  return numbers;
}

}  // namespace

std::vector<Doubt> unused_doubts(const io::Snapshot& begun, const dem::Scenario& scenario) {
  std::vector<Doubt> doubts;
  const dem::Model& model = scenario.model;
  const std::vector<std::size_t> materials =
      unnamed(1, model.materials.size(), {&begun.grains.material_id, &begun.planes.material_id});
  if (!materials.empty())
    doubts.push_back({"unused-material",
                      fmt::format("no grain, node or plane has material {0}, so that [[material]] {0} has no effect: "
                                  "material 0 is [contact], and 1 the first [[material]]; leave it out, or move its "
                                  "keys to the material that is meant",
                                  fmt::join(materials, " or "))});
  const std::vector<std::size_t> geotextiles = unnamed(0, model.geotextiles.size(), {&begun.yarns.geotextile_id});
  if (!geotextiles.empty())
    doubts.push_back({"unused-geotextile",
                      fmt::format("no yarn has geotextile {0}, so that [[geotextile]] {0} has no effect: the first one "
                                  "is 0; wrap the packing in it (filter-expand), or leave it out",
                                  fmt::join(geotextiles, " or "))});
  return doubts;
}

std::vector<Doubt> yarn_doubts(const io::Snapshot& begun, const dem::Scenario& scenario) {
  const io::YarnsRecord& yarns = begun.yarns;
  std::vector<Doubt> doubts;
  for (std::size_t g = 0; g < scenario.model.geotextiles.size(); ++g) {
    double length = 0, count = 0;
    for (std::size_t y = 0; y < yarns.size(); ++y)
      if (yarns.geotextile_id[y] == static_cast<std::int32_t>(g)) length += yarns.rest_length[y], count += 1;
    if (count == 0) continue;
    const double apart = length / count, tension = std::ranges::max(scenario.model.geotextiles[g].tension);
    const double strength = tension / apart, sheet = scenario.model.geotextiles[g].strength;
    const double width = sheet > 0 ? tension / sheet : apart;
    const std::string found = fmt::format(
        "yarns of geotextile {} are some {:.3g} mm apart and bear {:.4g} N at most, which is {:.3g} kN/m where ", g,
        1e3 * apart, tension, 1e-3 * strength);
    const auto say = [&](const std::string& key, const std::string& rest) {
      doubts.push_back({g == 0 ? key : fmt::format("{}-{}", key, g), found + rest});
    };
    if (std::max(apart / width, width / apart) > farthest_width)
      say("spacing",
          fmt::format("their file has a strength of {:.3g} kN/m: give the tensions of yarns so far apart, or "
                      "multiple = {:.3g}",
                      1e-3 * sheet, apart / width));
    else if (strength < weakest || strength > strongest)
      say("yarn",
          fmt::format("geotextiles have {:.0f} to {:.0f}: a curve gives the tension of one yarn, in N, which is "
                      "that in kN/m times {:.3g}",
                      1e-3 * weakest, 1e-3 * strongest, 1e3 * apart));
  }
  return doubts;
}

std::vector<Doubt> tolerance_doubts(const std::string& key, double off) {
  if (off <= most_off) return {};
  return {
      {"tolerance", fmt::format("{} is {:.3g}, which is {:.3g} %: states are recorded that are not at rest at their "
                                "stresses; give {} or less",
                                key, off, 100 * off, most_off)}};
}

std::vector<Doubt> tolerance_doubts(const dem::Tolerances& tolerances) {
  std::vector<Doubt> forces = tolerance_doubts("equilibrium.unbalanced_force", tolerances.unbalanced_force);
  return forces.empty() ? tolerance_doubts("equilibrium.stress_tolerance", tolerances.stress) : forces;
}

std::vector<Doubt> input_doubts(const io::Snapshot& begun, const dem::Scenario& scenario) {
  std::vector<Doubt> all = unused_doubts(begun, scenario);
  for (const std::vector<Doubt>& more : {yarn_doubts(begun, scenario), tolerance_doubts(scenario.tolerances)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace soilweave::analysis
