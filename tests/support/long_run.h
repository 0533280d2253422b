// A packing at rest, stepped for a long time without damping: what drifts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "dem/simulation.h"
#include "support/assemblies.h"

namespace soilweave::testing {

inline Vec3 momentum(const io::GrainsRecord& grains) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < grains.size(); ++i) sum += grains.mass[i] * grains.velocity[i];
  return sum;
}

/// Momentum if every grain moved with the root mean square of their speeds in the same direction.
inline double momentum_scale(const io::GrainsRecord& grains, double kinetic) {
  double mass = 0;
  for (const double m : grains.mass) mass += m;
  return std::sqrt(2 * kinetic * mass);
}

/// Elastic contacts that never slide, no damping, a cell that stands still. Energy may drift by 1e-6 of what is stored;
/// momentum and the length of quaternions by rounding alone, which adds up like a random walk, and the cell not at all.
inline void expect_no_drift(std::size_t grains, std::int64_t steps) {
  const dem::Model elastic = sand(89 * degree);
  dem::Numerics damped;
  damped.damping = 0.7;
  dem::Simulation resting(packed(elastic, 1e5, grains), elastic, damped);
  // What carries comes to rest; grains that carry nothing would fly on.
  for (int round = 0; round < 5; ++round) {
    for (int k = 0; k < 2000; ++k) resting.step();
    resting.stop_motion();
  }
  const io::Snapshot start = resting.snapshot();
  dem::Numerics undamped;
  undamped.damping = 0;
  dem::Simulation simulation(start, elastic, undamped);
  const Vec3 momentum_before = momentum(start.grains);
  const double stored = simulation.energies().elastic() + simulation.energies().kinetic;
  double largest_error = 0, largest_kinetic = 0;
  for (std::int64_t k = 1; k <= steps; ++k) {
    simulation.step();
    if (k % 1000 != 0) continue;
    largest_error = std::max(largest_error, std::abs(simulation.energies().error()));
    largest_kinetic = std::max(largest_kinetic, simulation.energies().kinetic);
  }
  const io::Snapshot end = simulation.snapshot();
  EXPECT_LE(largest_error, 1e-6 * stored);
  EXPECT_LT(largest_kinetic, 1e-3 * stored) << "it is no longer at rest";
  const double rounding = 1e-16 * std::sqrt(static_cast<double>(steps) * static_cast<double>(grains));
  EXPECT_LT((momentum(end.grains) - momentum_before).norm(), 100 * rounding * momentum_scale(end.grains, stored));
  for (const Vec4& q : end.grains.orientation) EXPECT_NEAR(q.norm(), 1, 1e-14);
  EXPECT_EQ(end.cell.matrix, start.cell.matrix);
  ::testing::Test::RecordProperty("relative_energy_drift", std::to_string(largest_error / stored));
}

}  // namespace soilweave::testing
