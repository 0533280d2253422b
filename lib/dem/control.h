// The servo of the periodic cell: stress or strain goals on each axis become the velocity gradient of the next step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "dem/simulation.h"

namespace soilweave::dem {

/// What one cell axis is asked for. Compression positive.
struct AxisGoal {
  enum class Kind { stress, strain };
  Kind kind = Kind::strain;
  double value = 0;     // Pa, or natural strain since the reference
  double max_rate = 0;  // 1/s, of the strain
};
using AxisGoals = std::array<AxisGoal, 3>;

struct Tolerances {
  double stress = 1e-3;                                             // relative to the goal
  double unbalanced_force = 1e-3;                                   // mean resultant over mean contact force
  double kinetic_energy = std::numeric_limits<double>::infinity();  // J, of what is acted on
};

/// How an axis follows its stress goal.
struct ServoRule {
  enum class Kind {
    // Proportional-integral, critically damped, with gains that follow the contact network's own stiffness, so that the
    // response takes the same number of steps for any number of grains, stiffness and pressure.
    stiffness,
    // The cell's strain rate grows by the stress error over the grains' total mass (Pa/kg taken as 1/s2, as the thesis'
    // runs had it), damped like a grain. It rings, and slows down as the packing grows; to repeat those runs.
    inertia
  };
  Kind kind = Kind::stiffness;
  double damping = 0.25;  // of `inertia`
};

class Servo {
 public:
  explicit Servo(const ServoRule& rule = {}) : rule_(rule) {}
  /// Sets the velocity gradient of the next step, strain goals at this share of their largest rate; axes beyond the
  /// space's dimension stay at rest.
  void drive(const AxisGoals& goals, int dimension, Simulation& simulation, double pace = 1);
  /// Strain goals met.
  static bool strained(const AxisGoals& goals, int dimension, const Simulation& simulation);
  /// All goals met within the tolerances and the unbalanced force below its own.
  static bool settled(const AxisGoals& goals, int dimension, const Tolerances& tolerances,
                      const Simulation& simulation);
  /// What it remembers from step to step.
  void archive(Archive& archive) { archive.item("servo_rate", rate_); }

 private:
  double stress_rate(int axis, const AxisGoal& goal, const Simulation& simulation);

  ServoRule rule_;
  Vec3 rate_ = Vec3::Zero();  // 1/s, the integral part, compression positive
};

}  // namespace soilweave::dem
