// Grains held together rigidly, without rotation of the whole: they move as they are told, whatever pulls at them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/bodies.h"

namespace soilweave::dem {

struct Clamp {
  std::vector<std::int32_t> grains;
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 force = Vec3::Zero();     // N, of its grains on the clamp, gravity included
};

class Clamps {
 public:
  std::vector<Clamp> all;

  /// Takes the forces off the clamped grains, so that the next step moves them at the clamp's velocity; to be called
  /// when all forces are summed. Returns the work that the clamps did over a step dt that led here, J.
  double take(const Vec3& gravity, double dt, Bodies& bodies);
  /// Lets clamp k move at a velocity from now on. Returns the kinetic energy this gives, J.
  double set_velocity(std::size_t k, const Vec3& velocity, Bodies& bodies);
};

}  // namespace soilweave::dem
