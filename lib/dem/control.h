// The servo of the periodic cell: stress or strain goals on each axis become the velocity gradient of the next step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

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
  double stress = 1e-3;            // relative to the goal
  double unbalanced_force = 1e-3;  // mean resultant over mean contact force
};

/// A proportional-integral servo whose gains follow the contact network's own stiffness, so that its response takes the
/// same number of steps for any number of grains, stiffness and pressure. (The peer's servo divides a stress by the
/// total mass, dem-laws §6: it slows down as the packing grows.)
class Servo {
 public:
  /// Sets the velocity gradient of the next step; axes beyond the space's dimension stay at rest.
  void drive(const AxisGoals& goals, int dimension, Simulation& simulation);
  /// All goals met within the tolerances and the unbalanced force below its own.
  static bool settled(const AxisGoals& goals, int dimension, const Tolerances& tolerances,
                      const Simulation& simulation);

 private:
  Vec3 rate_ = Vec3::Zero();  // 1/s, the integral part, compression positive
};

}  // namespace soilweave::dem
