// Grains that move while their pairs are swept, chunk by chunk, give the bits of separate passes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/step_passes.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <numeric>
#include <random>

#include "dem/state/chunk_plan.h"
#include "packing/expand/tile.h"
#include "support/assemblies.h"
#include "support/engine_parts.h"

namespace soilweave::dem {
namespace {

using support::same_bits;
using Reached = std::vector<std::vector<std::uint32_t>>;

// Returns chunks, each of which reaches some of the higher ones.
Reached random_reach(std::size_t chunks, std::mt19937& engine) {
  Reached reached(chunks);
  for (std::size_t one = 0; one < chunks; ++one)
    for (std::size_t two = one + 1; two < chunks; ++two)
      if (engine() % 3 == 0) reached[one].push_back(static_cast<std::uint32_t>(two));
  return reached;
}

TEST(ChunkPlan, MovesSweepsAndCollectsEveryChunkOnceAndInOrder) {
  std::mt19937 engine(7);
  for (const int threads : {1, 2, 3, 16})
    for (const std::size_t chunks : {0u, 1u, 2u, 9u, 40u}) {
      const Reached reached = random_reach(chunks, engine);
      std::vector<std::size_t> work(chunks);
      for (std::size_t& of_chunk : work) of_chunk = 1 + engine() % 100;
      std::atomic<int> clock = 0;
      std::vector<int> moved(chunks, -1), swept(chunks, -1), collected(chunks, -1);
      const auto note = [&clock](std::vector<int>& when) {
        return [&clock, &when](std::size_t chunk) {
          EXPECT_EQ(when[chunk], -1);
          when[chunk] = clock++;
        };
      };
      ChunkPlan(reached, work, threads).run(note(moved), note(swept), note(collected));
      EXPECT_EQ(clock, 3 * static_cast<int>(chunks));
      for (std::size_t one = 0; one < chunks; ++one) {
        EXPECT_LT(moved[one], swept[one]);
        EXPECT_LT(swept[one], collected[one]);
        for (const std::uint32_t two : reached[one]) {
          EXPECT_LT(moved[two], swept[one]);
          EXPECT_LT(swept[one], collected[two]);
        }
      }
    }
}

// The last chunks of a bag are nodes, which have no pairs of their own.
TEST(ChunkPlan, SharesHoldEqualWorkHoweverItIsSpread) {
  std::vector<std::size_t> work(20, 1);
  std::fill(work.begin(), work.begin() + 10, 100);
  const std::size_t total = std::accumulate(work.begin(), work.end(), std::size_t{0});
  std::array<std::atomic<std::size_t>, 2> done{};
  const auto idle = [](std::size_t) {};
  ChunkPlan(Reached(work.size()), work, 2)
      .run(
          idle, [&](std::size_t chunk) { done[static_cast<std::size_t>(omp_get_thread_num())] += work[chunk]; }, idle);
  EXPECT_EQ(done[0] + done[1], total);
  // Shares are equal except for the seventh that any thread may take, and a chunk at either end.
  for (const auto& share : done) EXPECT_GE(share + 200, total / 2 * 6 / 7);
}

double fastest(const Bodies& bodies) {
  double v = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) v = std::max(v, vector_of(bodies.velocity(i)).norm());
  return v;
}

// Several chunks of grains in a cell that is compressed and sheared.
struct Stepper : support::EngineParts {
  explicit Stepper(int threads) : EngineParts(state(), make_contact_sweep(support::sand()), threads) {
    Mat3 gradient = Vec3(-0.5, 0.3, -0.8).asDiagonal();
    gradient(0, 1) = 0.4;
    cell.set_velocity_gradient(gradient);
    act(0);
  }
  static const io::Snapshot& state() {
    static const io::Snapshot tiled =
        packing::tile(support::packed(support::sand(), 1e5, 400), {2, 2, 3}, {true, true, true});
    return tiled;
  }
  // Returns whether the grains moved within the sweep.
  bool step(double dt, bool may_move_within) {
    const Vec3 gravity(0, 0, -9.81);
    motion.set_out(cell, gravity, 0.2, dt, bodies);
    const double gain = motion.gain_bound(bodies.smallest_mass()), before = fastest(bodies);
    const Mat3& gradient = cell.velocity_gradient();
    const bool within = may_move_within && neighbours.outlast(gain, gradient, dt);
    if (!within) motion.advance_all(bodies);
    cell.advance(dt);
    if (!within && neighbours.outdated(bodies, motion.advanced().skin_rate, 0, gradient, dt))
      neighbours.rebuild(bodies, cell, planes, contacts), ++rebuilt;
    act(dt, within);
    EXPECT_LE(motion.advanced().fastest, (1 + 1e-12) * (before + gain));  // except for rounding
    if (within) {
      EXPECT_FALSE(neighbours.outdated(bodies, motion.advanced().skin_rate, 0, gradient, dt));
    }
    return within;
  }

  int rebuilt = 0;
};

TEST(StepPasses, WithinTheSweepGiveTheBitsOfOnePassAfterTheOther) {
  Stepper apart(1), within(1), shared(2);
  ASSERT_GT(apart.contacts.chunks.size(), 3u);
  int moved_within = 0;
  constexpr int steps = 200;
  for (int k = 0; k < steps; ++k) {
    apart.step(2e-5, false);
    moved_within += within.step(2e-5, true);
    shared.step(2e-5, true);
    for (const Stepper* other : {&within, &shared}) {
      ASSERT_TRUE(same_bits(apart.bodies.grains, other->bodies.grains)) << "step " << k;
      ASSERT_TRUE(same_bits(apart.bodies.loads, other->bodies.loads)) << "step " << k;
      ASSERT_EQ(std::memcmp(&apart.sums, &other->sums, sizeof apart.sums), 0) << "step " << k;
    }
  }
  EXPECT_GT(moved_within, steps / 2);
  EXPECT_GT(within.rebuilt, 2);
}

}  // namespace
}  // namespace soilweave::dem
