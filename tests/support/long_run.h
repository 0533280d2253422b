// A packing at rest, stepped for a long time without damping, to measure drift.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dem/engine/simulation.h"
#include "support/assemblies.h"
#include "support/worse.h"

namespace soilweave::support {

inline Vec3 momentum(const io::GrainsRecord& grains) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < grains.size(); ++i) sum += grains.mass[i] * grains.velocity[i];
  return sum;
}

/// Returns the momentum if every grain moved with the root mean square speed in one direction.
inline double momentum_scale(const io::GrainsRecord& grains, double kinetic) {
  double mass = 0;
  for (const double m : grains.mass) mass += m;
  return std::sqrt(2 * kinetic * mass);
}

/// Runs elastic contacts that never slide, without damping, in a cell at rest. Energy may drift by 1e-6 of the stored
/// energy, the law's own creation included. Momentum and the length of quaternions may drift only by rounding, which
/// adds up like a random walk. The cell may not drift at all.
///
/// The grains were packed with the friction of sand. A shear force that turns with its pair has no potential: its
/// tangent stiffness is unsymmetric by |Fs| over the branch, in all codes that turn it by the mean spin. Modes of
/// nearly one frequency then draw on the shear forces, at a rate that does not depend on the step (flutter). In
/// packings made without sliding, whose shear forces are as large as their normal forces, a million steps set some 1e-5
/// of the stored energy in motion; here it is about 1e-11.
inline void expect_no_drift(std::size_t grains, std::int64_t steps) {
  const dem::Model elastic = sand(89 * degree);
  dem::Numerics damped;
  damped.damping = 0.7;
  dem::Simulation resting(packed(sand(), 1e5, grains), elastic, damped);
  // Only grains that carry come to rest; grains that carry nothing would fly on.
  for (int round = 0; round < 5; ++round) {
    for (int k = 0; k < 2000; ++k) resting.step();
    resting.slow_motion(0);
  }
  const io::Snapshot start = resting.snapshot();
  dem::Numerics undamped;
  undamped.damping = 0;
  dem::Simulation simulation(start, elastic, undamped);
  const Vec3 momentum_before = momentum(start.grains);
  const double stored = simulation.energies().stored() + simulation.energies().kinetic();
  double largest_error = 0, largest_drift = 0, largest_kinetic = 0;
  for (std::int64_t k = 1; k <= steps; ++k) {
    simulation.step();
    if (k % 1000 != 0) continue;
    const dem::Energies now = simulation.energies();
    largest_error = soilweave::test::worse(largest_error, std::abs(now.error()));
    largest_drift = soilweave::test::worse(largest_drift, std::abs(now.kinetic() + now.stored() - stored));
    largest_kinetic = soilweave::test::worse(largest_kinetic, now.kinetic());
  }
  const io::Snapshot end = simulation.snapshot();
  EXPECT_LE(largest_error, 1e-6 * stored);
  EXPECT_LE(largest_drift, 1e-6 * stored);
  EXPECT_LT(largest_kinetic, 1e-6 * stored) << "it is no longer at rest";
  const double rounding = 1e-16 * std::sqrt(static_cast<double>(steps) * static_cast<double>(grains));
  EXPECT_LT((momentum(end.grains) - momentum_before).norm(), 100 * rounding * momentum_scale(end.grains, stored));
  for (const Vec4& q : end.grains.orientation) EXPECT_NEAR(q.norm(), 1, 1e-14);
  EXPECT_EQ(end.cell.matrix, start.cell.matrix);
  ::testing::Test::RecordProperty("relative_energy_drift", fmt::format("{:.2e}", largest_drift / stored));
}

}  // namespace soilweave::support
