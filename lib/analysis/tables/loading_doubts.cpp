// Doubts about the materials and stages of a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/loading_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "analysis/measure/stress.h"

namespace soilweave::analysis {
namespace {

// Relative difference of stresses above which a stage changes what it should hold.
constexpr double largest_jump = 0.1;
// Largest mean overlap over the mean radius. Hertz's law holds for small overlaps, and sand at 1 MPa has 0.01.
constexpr double largest_overlap = 0.05;

bool strains(const dem::AxisGoal& goal) { return goal.kind == dem::AxisGoal::Kind::strain && goal.value != 0; }

}  // namespace

std::vector<Doubt> jump_doubts(const io::Snapshot& start, const dem::Scenario& scenario) {
  const auto axes = static_cast<std::size_t>(start.grains.dimension);
  if (std::count(start.cell.periodic.begin(), start.cell.periodic.begin() + start.grains.dimension, false) > 0)
    return {};
  Mat3 held = cell_stress(start);
  std::array<bool, 3> known = {true, true, true};
  for (const dem::Stage& stage : scenario.stages) {
    const dem::PathState before{start.grains.dimension, held, Vec3::Zero()};
    const dem::AxisGoals first = stage.path->goals(0, before);
    for (std::size_t a = 0; a < axes && std::any_of(first.begin(), first.begin() + start.grains.dimension, strains);
         ++a) {
      const auto k = static_cast<Eigen::Index>(a);
      if (first[a].kind != dem::AxisGoal::Kind::stress || !known[a]) continue;
      if (std::abs(first[a].value - held(k, k)) <= largest_jump * std::max(first[a].value, held(k, k))) continue;
      return {{"jump",
               fmt::format(
                   "stage \"{}\" holds {:.4g} kPa along {} where {:.4g} kPa act before it: it strains the grains while "
                   "that stress changes; bring them there first, by a stage of path \"isotropic\"",
                   stage.name, first[a].value / 1e3, "xyz"[a], held(k, k) / 1e3)}};
    }
    const dem::AxisGoals last = stage.path->goals(stage.path->stations() - 1, before);
    for (std::size_t a = 0; a < axes; ++a) {
      const auto k = static_cast<Eigen::Index>(a);
      known[a] = last[a].kind == dem::AxisGoal::Kind::stress;
      if (known[a]) held(k, k) = last[a].value;
    }
  }
  return {};
}

std::vector<Doubt> friction_doubts(const dem::Scenario& scenario) {
  std::vector<double> angles;
  for (std::size_t m = 0; m < scenario.model.materials.size(); ++m)
    angles.push_back(scenario.model.materials.at(m).friction_angle);
  for (const dem::Stage& stage : scenario.stages)
    for (const std::optional<double>& angle : {stage.friction, stage.plate_friction})
      if (angle) angles.push_back(*angle);
  constexpr double degree = std::numbers::pi / 180;
  for (const double angle : angles)
    if (angle > 0 && angle < std::numbers::pi / 2 * degree)
      return {{"friction",
               fmt::format("a friction angle of {:.3g} degrees is next to none; if radians are meant, write {:.4g}",
                           angle / degree, angle / degree / degree)}};
  return {};
}

std::vector<Doubt> overlap_doubts(const io::Snapshot& state) {
  const std::vector<double>&overlaps = state.contacts.overlap, &radii = state.grains.radius;
  if (overlaps.empty()) return {};
  const double overlap = std::reduce(overlaps.begin(), overlaps.end()) / static_cast<double>(overlaps.size());
  const double radius = std::reduce(radii.begin(), radii.end()) / static_cast<double>(radii.size());
  if (overlap <= largest_overlap * radius) return {};
  return {
      {"soft",
       fmt::format(
           "contacts overlap by {:.2g} of the mean radius in the mean, more than {:.2g}: grains are too soft for the "
           "stress; take a greater Young's modulus, or less stress",
           overlap / radius, largest_overlap)}};
}

}  // namespace soilweave::analysis
