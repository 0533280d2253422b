// Clamps: grains held together that move at a prescribed velocity without rotation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/state/bodies.h"

namespace soilweave::dem {

/// One clamp.
struct Clamp {
  /// Indices of its grains.
  std::vector<std::int32_t> grains;
  /// Prescribed velocity, m/s.
  Vec3 velocity = Vec3::Zero();
  /// Force of its grains on the clamp, gravity included, N.
  Vec3 force = Vec3::Zero();
};

/// All clamps of a simulation.
class Clamps {
 public:
  /// Clamps in the order of Numerics::clamps.
  std::vector<Clamp> all;

  /// Transfers the forces on clamped grains to their clamps. Call it once all forces are summed.
  /// The next step then moves these grains at the clamp's velocity. Returns the clamps' work over the last step, J.
  double take(const Vec3& gravity, double dt, Bodies& bodies);
  /// Sets the velocity of clamp k. Returns the gain of kinetic energy, J.
  double set_velocity(std::size_t k, const Vec3& velocity, Bodies& bodies);
};

}  // namespace soilweave::dem
