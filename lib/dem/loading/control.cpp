// The servo of the periodic cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/control.h"

#include <algorithm>
#include <cmath>

namespace soilweave::dem {
namespace {

// Natural frequency of the servo times the step: faster than the loading, slower than the oscillation of grains.
constexpr double frequency_times_step = 0.05;
constexpr double servo_damping = 1.0;  // fraction of critical damping
// Least stiffness of an axis, as a multiple of its stress goal, for contact networks that are too loose.
constexpr double loosest_stiffness = 10.0;
// Tolerance of a strain goal.
constexpr double strain_tolerance = 1e-9;

}  // namespace

double Servo::stress_rate(int axis, const AxisGoal& goal, const Simulation& simulation) {
  const double dt = simulation.time_step();
  const Measures& m = simulation.measures();
  const double error = goal.value - m.stress(axis, axis);
  if (rule_.kind == ServoRule::Kind::inertia) {
    const double side = static_cast<double>((rate_[axis] * error > 0) - (rate_[axis] * error < 0));
    rate_[axis] += (1 - rule_.damping * side) * dt * error / simulation.mass();
    rate_[axis] = std::clamp(rate_[axis], -goal.max_rate, goal.max_rate);
    return rate_[axis];
  }
  const double stiffness = std::max(m.axial_stiffness[axis], loosest_stiffness * std::abs(goal.value));
  if (!(stiffness > 0)) return 0;
  // Contacts with dashpots follow a strain rate more slowly, by this share, and so must the servo. Its square is
  // needed, because the step is shorter by the same share.
  const double dashpots = simulation.dashpot_share();
  const double omega = dashpots * dashpots * rule_.share_of_frequency * frequency_times_step / dt;
  rate_[axis] += omega * omega * error * dt / stiffness;
  rate_[axis] = std::clamp(rate_[axis], -goal.max_rate, goal.max_rate);
  return rate_[axis] + 2 * servo_damping * omega * error / stiffness;
}

void Servo::drive(const AxisGoals& goals, int dimension, Simulation& simulation, double pace) {
  const double dt = simulation.time_step();
  const Vec3 strain = simulation.strain();
  Mat3 gradient = Mat3::Zero();
  for (int a = 0; a < dimension; ++a) {
    const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
    const bool strained = goal.kind == AxisGoal::Kind::strain;
    const double rate = strained ? -std::expm1(-(goal.value - strain[a])) / dt : stress_rate(a, goal, simulation);
    const double largest = strained ? pace * goal.max_rate : goal.max_rate;
    gradient(a, a) = -std::clamp(rate, -largest, largest);
  }
  simulation.set_velocity_gradient(gradient);
}

bool Servo::strained(const AxisGoals& goals, int dimension, const Simulation& simulation) {
  const Vec3 strain = simulation.strain();
  for (int a = 0; a < dimension; ++a) {
    const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
    if (goal.kind == AxisGoal::Kind::strain && std::abs(goal.value - strain[a]) > strain_tolerance) return false;
  }
  return true;
}

bool Servo::settled(const AxisGoals& goals, int dimension, const Tolerances& tolerances, const Simulation& simulation) {
  if (!strained(goals, dimension, simulation)) return false;
  const Measures& m = simulation.measures();
  for (int a = 0; a < dimension; ++a) {
    const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
    if (goal.kind == AxisGoal::Kind::stress &&
        std::abs(goal.value - m.stress(a, a)) > tolerances.stress * std::abs(goal.value))
      return false;
  }
  return simulation.unbalanced_force() <= tolerances.unbalanced_force;
}

}  // namespace soilweave::dem
