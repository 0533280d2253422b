// The servo of the periodic cell turns goals on each axis into a velocity gradient.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "dem/engine/simulation.h"

namespace soilweave::dem {

/// Goal of one cell axis. Compression positive.
struct AxisGoal {
  /// Quantity that the axis is driven to.
  enum class Kind { stress, strain };
  Kind kind = Kind::strain;
  /// Stress, Pa, or natural strain since the reference.
  double value = 0;
  /// Greatest strain rate, 1/s.
  double max_rate = 0;
};
/// Goals of the axes x, y, z.
using AxisGoals = std::array<AxisGoal, 3>;

/// Tolerances within which a station counts as settled.
struct Tolerances {
  /// Tolerance of a stress, relative to its goal.
  double stress = 1e-3;
  /// Greatest unbalanced force: mean resultant over mean contact force.
  double unbalanced_force = 1e-3;
  /// Greatest kinetic energy of grains under load, J.
  double kinetic_energy = std::numeric_limits<double>::infinity();
};

/// Rule by which an axis follows its stress goal.
struct ServoRule {
  /// Law from stress error to strain rate.
  enum class Kind {
    /// A proportional-integral controller, critically damped. Its gains follow the stiffness of the contact network.
    stiffness,
    /// The strain rate accelerates by stress error over total mass (Pa/kg taken as 1/s2), damped like a grain.
    /// This rule oscillates. Use it only to repeat the thesis's runs.
    inertia
  };
  Kind kind = Kind::stiffness;
  /// Damping of `inertia`.
  double damping = 0.25;
  /// Frequency of `stiffness` over that for steps of the default safety. With smaller steps the gains do not grow.
  double share_of_frequency = 1;
};

/// A controller of all cell axes. One object serves one run, since it keeps an integral part.
class Servo {
 public:
  /// Makes a controller at rest.
  explicit Servo(const ServoRule& rule = {}) : rule_(rule) {}
  /// Sets the velocity gradient of the next step. Axes beyond the dimension stay at rest.
  /// pace: share of the greatest rate at which strain goals are approached.
  void drive(const AxisGoals& goals, int dimension, Simulation& simulation, double pace = 1);
  /// Returns whether all strain goals are met.
  static bool strained(const AxisGoals& goals, int dimension, const Simulation& simulation);
  /// Returns whether all goals and the unbalanced force are within their tolerances.
  static bool settled(const AxisGoals& goals, int dimension, const Tolerances& tolerances,
                      const Simulation& simulation);
  /// Keeps or restores the state of the servo.
  void archive(Archive& archive) { archive.item("servo_rate", rate_); }

 private:
  /// Returns the strain rate, 1/s, that brings an axis to its stress.
  double stress_rate(int axis, const AxisGoal& goal, const Simulation& simulation);

  ServoRule rule_;
  /// Integral part, 1/s, compression positive.
  Vec3 rate_ = Vec3::Zero();
};

}  // namespace soilweave::dem
