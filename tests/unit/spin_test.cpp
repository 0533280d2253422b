// Grains that spin fast: their orientation stays a rotation, whatever the angle per step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "dem/engine/simulation.h"
#include "support/assemblies.h"

namespace soilweave::dem {
namespace {

TEST(Spin, LeavesAUnitQuaternionHoweverFast) {
  io::Snapshot start = support::packed(support::sand(), 1e5, 60);
  Numerics numerics;
  numerics.damping = 0;
  const double dt = Simulation(start, support::sand(), numerics).time_step();
  // Angles per step, rad. Grains of one pass spin at different angles, so that slow grains lie beside fast grains.
  constexpr double paces[] = {0, 1e-3, 0.05, 0.077, 0.08, 0.18, 1, 3, 100, 1e6};
  start.contacts = {};
  for (std::size_t i = 0; i < start.grains.size(); ++i) {
    start.grains.orientation[i] = Vec4(1, 0, 0, 0);
    start.grains.velocity[i].setZero();
    // Grains are apart, so that no contact slows them.
    start.grains.radius[i] *= 0.5;
    start.grains.angular_velocity[i] = paces[i % 10] / dt * Vec3(0.6, 0, 0.8);
  }
  Simulation simulation(start, support::sand(), numerics);
  for (int k = 0; k < 50; ++k) simulation.step();
  const io::Snapshot state = simulation.snapshot();
  EXPECT_NO_THROW(io::check(state, "spinning"));
  // Expected angle of the scheme: 2 atan(half the angle) per step.
  const double share = simulation.time_step() / dt;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const double half = 0.5 * paces[i % 10] * share;
    EXPECT_NEAR(std::abs(state.grains.orientation[i][0]), std::abs(std::cos(50 * std::atan(half))), 1e-3) << i;
  }
}

}  // namespace
}  // namespace soilweave::dem
