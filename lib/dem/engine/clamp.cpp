// Clamps: grains held rigidly together.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/clamp.h"

namespace soilweave::dem {

double Clamps::take(const Vec3& gravity, double dt, Bodies& bodies) {
  double work = 0;
  for (Clamp& clamp : all) {
    Vec3 force = Vec3::Zero();
    for (const std::int32_t g : clamp.grains) {
      const auto i = static_cast<std::size_t>(g);
      const Lane4 weight = bodies.mass(i) * row(gravity, 0);
      force += vector_of(bodies.loads[i].force + weight);
      bodies.loads[i].force = -weight;
    }
    work -= 0.5 * dt * (clamp.force + force).dot(clamp.velocity);
    clamp.force = force;
  }
  return work;
}

double Clamps::set_velocity(std::size_t k, const Vec3& velocity, Bodies& bodies) {
  Clamp& clamp = all[k];
  double given = 0;
  for (const std::int32_t g : clamp.grains) {
    const auto i = static_cast<std::size_t>(g);
    const Vec3 before = vector_of(bodies.velocity(i));
    given += 0.5 * bodies.mass(i) * (velocity.squaredNorm() - before.squaredNorm());
    bodies.set_velocity(i, velocity);
  }
  clamp.velocity = velocity;
  return given;
}

}  // namespace soilweave::dem
