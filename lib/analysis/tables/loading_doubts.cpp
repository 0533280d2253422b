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
#include "analysis/measure/tessellation.h"
#include "core/text/units.h"

namespace soilweave::analysis {
namespace {

// Relative difference of stresses above which a stage changes what it should hold.
constexpr double largest_jump = 0.1;
// Largest mean overlap over the mean radius. Hertz's law holds for small ones: a thousand grains of 4 GPa have 0.0037
// under 100 kPa and 0.015 under 1 MPa.
constexpr double largest_overlap = 0.05;

bool strains(const dem::AxisGoal& goal) { return goal.kind == dem::AxisGoal::Kind::strain && goal.value != 0; }

// Stresses that act along the axes at the start of a stage, Pa (2D: N/m); unknown where the stage before strained.
struct Acting {
  Mat3 stress;
  std::array<bool, 3> known;

  // Returns the state with `unknown` times the stresses that are not known.
  dem::PathState state(int dimension, double unknown) const {
    Mat3 all = stress;
    for (Eigen::Index a = 0; a < 3; ++a)
      if (!known[static_cast<std::size_t>(a)]) all(a, a) *= unknown;
    return {dimension, all, Vec3::Zero()};
  }
};

// Returns whether a stage holds one known stress along an axis: no ramp, nor one that follows from unknown stresses.
bool holds(const dem::Stage& stage, const Acting& before, int dimension, std::size_t axis) {
  const auto goal = [&](std::size_t station, double unknown) {
    return stage.path->goals(station, before.state(dimension, unknown))[axis];
  };
  const dem::AxisGoal first = goal(0, 1);
  return first.kind == dem::AxisGoal::Kind::stress && first.value == goal(0, 2).value &&
         first.value == goal(stage.path->stations() - 1, 1).value;
}

}  // namespace

std::vector<Doubt> jump_doubts(const io::Snapshot& start, const dem::Scenario& scenario) {
  const int dimension = start.grains.dimension;
  if (!is_periodic(start)) return {};
  Acting acting{cell_stress(start), {true, true, true}};
  for (const dem::Stage& stage : scenario.stages) {
    const dem::AxisGoals first = stage.path->goals(0, acting.state(dimension, 1));
    const dem::AxisGoals last = stage.path->goals(stage.path->stations() - 1, acting.state(dimension, 1));
    const bool shears = std::any_of(first.begin(), first.begin() + dimension, strains);
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
      double& now = acting.stress(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(a));
      const double goal = first[a].value;
      if (shears && acting.known[a] && holds(stage, acting, dimension, a) &&
          std::abs(goal - now) > largest_jump * std::max(goal, now))
        return {
            {"jump",
             fmt::format(
                 "stage \"{}\" holds {:.4g} {} along {} where {:.4g} act before it: it strains the grains while that "
                 "stress changes; bring it there first, by a stage of path \"isotropic\", or \"free\" for other "
                 "stresses along other axes",
                 stage.name, goal / 1e3, dimension == 3 ? "kPa" : "kN/m", "xyz"[a], now / 1e3)}};
    }
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
      acting.known[a] = last[a].kind == dem::AxisGoal::Kind::stress;
      if (acting.known[a]) acting.stress(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(a)) = last[a].value;
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
  return radian_doubts(angles);
}

std::vector<Doubt> radian_doubts(const std::vector<double>& angles) {
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
