// Doubts about the materials and stages of a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/doubts/loading_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "analysis/measure/stress.h"
#include "analysis/measure/tessellation.h"
#include "analysis/measure/volume_of_interest.h"
#include "core/text/units.h"

namespace soilweave::analysis {
namespace {

// Largest relative difference between two stresses that is no jump.
constexpr double largest_jump = 0.1;
// Largest mean overlap over the mean radius. Hertz's law holds for small overlaps. A thousand grains of 4 GPa have
// 0.0037 under 100 kPa and 0.015 under 1 MPa.
constexpr double largest_overlap = 0.05;
// Relative change of the summed overlaps above which moved grains, not another law, changed the stress. Forces grow
// with the overlap or its power 1.5. So a tenth more stress means at least a fifteenth more overlap.
constexpr double largest_shift = 0.05;
// Strain above which a missing % sign is likelier. Shearing a packing to its critical state takes a natural strain of
// 0.3.
constexpr double largest_strain = 0.5;
// Share of a stress below which lowering it is no common unloading. A stress in kPa read as Pa is a thousandth.
constexpr double least_share = 0.02;
// Stress below which a number without a unit is doubted, Pa: that of sand under 3 cm of sand.
constexpr double least_stress = 500;
// Stress from which a number without a unit is meant in Pa, Pa: few soils are tested at 5000 kPa.
constexpr double clear_stress = 5e3;

bool strains(const dem::AxisGoal& goal) { return goal.kind == dem::AxisGoal::Kind::strain && goal.value != 0; }

// Stresses along the axes at the start of a stage, Pa (2D: N/m). A stress is unknown if the stage before strained its
// axis.
struct Acting {
  Mat3 stress;
  std::array<bool, 3> known;

  // Returns the state, with unknown stresses multiplied by `unknown`. Goals that differ between two factors depend on
  // them.
  dem::PathState state(int dimension, double unknown) const {
    Mat3 all = stress;
    for (Eigen::Index a = 0; a < 3; ++a)
      if (!known[static_cast<std::size_t>(a)]) all(a, a) *= unknown;
    return {dimension, all, Vec3::Zero()};
  }
};

// Returns whether a stage holds one known stress along an axis. A ramp does not, nor a goal that depends on unknown
// stresses.
bool holds(const dem::Stage& stage, const Acting& before, int dimension, std::size_t axis) {
  const auto goal = [&](std::size_t station, double unknown) {
    return stage.path->goals(station, before.state(dimension, unknown))[axis];
  };
  const dem::AxisGoal first = goal(0, 1);
  return first.kind == dem::AxisGoal::Kind::stress && first.value == goal(0, 2).value &&
         first.value == goal(stage.path->stations() - 1, 1).value;
}

// Contacts among grains, without those of planes.
struct AmongGrains {
  // Love-Weber stress, Pa (2D: N/m).
  Mat3 stress = Mat3::Zero();
  // Sum of the overlaps, m.
  double overlap = 0;
  std::size_t contacts = 0;
};

AmongGrains among_grains(const io::Snapshot& state) {
  AmongGrains sum;
  const io::ContactsRecord& contacts = state.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.bodies[c][1] < 0) continue;
    sum.stress += contacts.force(c) * contacts.branch_vector[c].transpose();
    sum.overlap += std::max(0.0, contacts.overlap[c]);
    ++sum.contacts;
  }
  sum.stress /= cell_volume(state);
  return sum;
}

// Returns whether a stage brings every axis to a given stress, so that a packing can come to rest.
bool equilibrates(const dem::Stage& stage, int dimension) {
  const dem::AxisGoals goals = stage.path->goals(0, {dimension, Mat3::Identity(), Vec3::Zero()});
  return std::all_of(goals.begin(), goals.begin() + dimension,
                     [](const dem::AxisGoal& goal) { return goal.kind == dem::AxisGoal::Kind::stress; });
}

// Returns the largest strain of any axis in a stage, with its sign.
double largest_strain_of(const dem::Stage& stage, int dimension) {
  double largest = 0;
  const auto see = [&](double strain) {
    if (std::abs(strain) > std::abs(largest)) largest = strain;
  };
  for (std::size_t station = 0; station < stage.path->stations(); ++station) {
    see(stage.path->nominal_strain(station));
    for (const dem::AxisGoal& goal : stage.path->goals(station, {dimension, Mat3::Identity(), Vec3::Zero()}))
      if (strains(goal)) see(goal.value);
  }
  return largest;
}

std::vector<Doubt> strain_doubts(int dimension, const dem::Scenario& scenario) {
  for (const dem::Stage& stage : scenario.stages) {
    const double strain = largest_strain_of(stage, dimension);
    if (std::abs(strain) <= largest_strain) continue;
    return {
        {"strain",
         fmt::format(
             "stage \"{0}\" strains an axis by {1:.4g}, which is {2:.4g} %: if {1:.4g} % is meant, write \"{1:.4g} %\"",
             stage.name, strain, 100 * strain)}};
  }
  return {};
}

std::vector<Doubt> stress_unit_doubts(const io::Snapshot& begun, const dem::Scenario& scenario) {
  const int dimension = begun.grains.dimension;
  if (!is_periodic(begun)) return {};
  Acting acting{cell_stress(begun), {true, true, true}};
  std::array<bool, 3> named = {false, false, false};  // axes whose stress a goal of this scenario has set
  for (const dem::Stage& stage : scenario.stages)
    for (std::size_t station = 0; station < stage.path->stations(); ++station) {
      const dem::AxisGoals goals = stage.path->goals(station, acting.state(dimension, 1));
      const dem::AxisGoals others = stage.path->goals(station, acting.state(dimension, 2));
      for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
        double& now = acting.stress(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(a));
        const bool given = goals[a].kind == dem::AxisGoal::Kind::stress && goals[a].value == others[a].value;
        // If the scenario sets the stress before and after an unloading, both are meant.
        const bool meant = named[a] && equilibrates(stage, dimension);
        if (given && !meant && acting.known[a] && goals[a].value > 0 && goals[a].value < least_share * now)
          return {{"stress-unit",
                   fmt::format(
                       "stage \"{0}\" lowers the stress along {1} from {2:.4g} to {3:.4g} Pa: if {3:.4g} kPa is meant, "
                       "write \"{3:.4g} kPa\"",
                       stage.name, "xyz"[a], now, goals[a].value)}};
        acting.known[a] = named[a] = given;
        if (given) now = goals[a].value;
      }
    }
  return {};
}

}  // namespace

std::optional<StressChange> stress_change(const io::Snapshot& start, const io::Snapshot& begun) {
  const int dimension = start.grains.dimension;
  const AmongGrains kept = among_grains(start), now = among_grains(begun);
  if (kept.contacts == 0) return std::nullopt;
  const double before = mean(kept.stress, dimension), after = mean(now.stress, dimension);
  const Mat3 change = now.stress - kept.stress;
  const double largest = change.diagonal().head(dimension).cwiseAbs().maxCoeff();
  if (!(largest > largest_jump * std::max(std::abs(before), std::abs(after)))) return std::nullopt;
  return StressChange{before, after, std::abs(now.overlap - kept.overlap) > largest_shift * kept.overlap};
}

std::vector<Doubt> start_doubts(const io::Snapshot& start, const io::Snapshot& begun, const dem::Scenario& scenario) {
  const int dimension = start.grains.dimension;
  const bool periodic = is_periodic(start);
  if (periodic && equilibrates(scenario.stages.front(), dimension)) return {};
  const std::optional<StressChange> change = stress_change(start, begun);
  if (!change) return {};
  const std::string cause =
      change->moved ? "the grains do not lie where their contacts were: take a --perturb of 1e-4 or less"
                    : fmt::format(
                          "the scenario has another law, stiffness or friction than the packing was made with: give "
                          "that one{}",
                          periodic ? ", or begin with a stage of path \"isotropic\"" : "");
  return {{"jump", fmt::format("the run begins at a mean stress of {:.4g} {} among the grains, and the packing's file "
                               "has {:.4g}: {}",
                               change->after / 1e3, dimension == 3 ? "kPa" : "kN/m", change->before / 1e3, cause)}};
}

std::vector<Doubt> jump_doubts(const io::Snapshot& begun, const dem::Scenario& scenario) {
  const int dimension = begun.grains.dimension;
  if (!is_periodic(begun)) return {};
  Acting acting{cell_stress(begun), {true, true, true}};
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

std::vector<Doubt> unit_doubts(const io::Snapshot& begun, const dem::Scenario& scenario) {
  std::vector<Doubt> doubts = strain_doubts(begun.grains.dimension, scenario);
  std::vector<Doubt> stresses = stress_unit_doubts(begun, scenario);
  if (stresses.empty() && begun.grains.dimension == 3) stresses = bare_stress_doubts(scenario.bare_stresses);
  std::move(stresses.begin(), stresses.end(), std::back_inserter(doubts));
  return doubts;
}

std::vector<Doubt> bare_stress_doubts(const std::vector<BareNumber>& stresses) {
  const auto in_pascals = [](const BareNumber& stress) { return std::abs(stress.value) >= clear_stress; };
  if (std::ranges::any_of(stresses, in_pascals)) return {};
  for (const BareNumber& stress : stresses)
    if (stress.value != 0 && std::abs(stress.value) < least_stress)
      return {
          {"stress-unit", fmt::format("{0} is {1:.4g} without a unit, which is {1:.4g} Pa: if {1:.4g} kPa is meant, "
                                      "write \"{1:.4g} kPa\", else \"{1:.4g} Pa\"",
                                      stress.key, stress.value)}};
  return {};
}

std::vector<Doubt> stage_friction_doubts(const dem::Scenario& scenario) {
  std::vector<double> angles;
  for (const dem::Stage& stage : scenario.stages)
    for (const std::optional<double>& angle : {stage.friction, stage.plate_friction})
      if (angle) angles.push_back(*angle);
  return radian_doubts(angles);
}

std::vector<Doubt> radian_doubts(const std::vector<double>& angles) {
  for (const double angle : angles)
    if (angle > 0 && angle < std::numbers::pi / 2 * degree)
      return {{"friction",
               fmt::format("a friction angle of {:.3g} degrees is nearly zero; if radians are meant, write {:.4g}",
                           angle / degree, angle / degree / degree)}};
  return {};
}

std::vector<Doubt> overlap_doubts(const io::Snapshot& state) {
  const std::vector<double>&overlaps = state.contacts.overlap, &radii = state.grains.radius;
  if (overlaps.empty()) return {};
  const double overlap = std::reduce(overlaps.begin(), overlaps.end()) / static_cast<double>(overlaps.size());
  const double radius = std::reduce(radii.begin(), radii.end()) / static_cast<double>(radii.size());
  if (overlap <= largest_overlap * radius) return {};
  return {{"soft",
           fmt::format("the mean overlap is {:.2g} of the mean radius, more than {:.2g}: grains are too soft for the "
                       "stress; take a greater Young's modulus, or less stress",
                       overlap / radius, largest_overlap)}};
}

}  // namespace soilweave::analysis
