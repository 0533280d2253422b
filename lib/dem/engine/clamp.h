// Clamps: grains held rigidly together without rotation. They move at a prescribed velocity, whatever force acts on
// them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/state/bodies.h"

namespace soilweave::dem {

/// One clamp: its grains by index, its velocity, and the force on it.
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
  std::vector<Clamp> all;

  /// Moves the forces from the clamped grains to the clamps, so that the next step moves these grains at the clamp's
  /// velocity. Call it after all forces are summed. Returns the work of the clamps over the step dt that led here, J.
  double take(const Vec3& gravity, double dt, Bodies& bodies);
  /// Sets the velocity of clamp k from now on. Returns the kinetic energy that this adds, J.
  double set_velocity(std::size_t k, const Vec3& velocity, Bodies& bodies);
};

}  // namespace soilweave::dem
