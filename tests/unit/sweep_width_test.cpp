// The sweep of eight contacts at a time gives the bits of the sweep of four.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "dem/contact_sweep.h"
#include "dem/motion.h"
#include "dem/neighbours.h"
#include "support/assemblies.h"

namespace soilweave::dem {
namespace {

// The sweep of eight as processors with AVX-512 run it, but lowered to the baseline (Makefile): the same source.
using Make = std::unique_ptr<ContactSweep> (*)(const Model&);

// Grains in a shearing cell, stepped by hand.
struct Stepper {
  Stepper(const io::Snapshot& state, const Model& model, Make make)
      : bodies(state.grains),
        cell(state.cell, 3),
        neighbours(bodies.largest_radius()),
        motion(bodies.size(), 1),
        sweep(make(model)) {
    cell.set_velocity_gradient(Vec3(-0.2, 0.1, -0.3).asDiagonal());
    neighbours.rebuild(bodies, cell, planes, contacts);
    sums = sweep->run(scene(), 0, contacts);
    motion.gather(contacts, bodies);
  }
  Scene scene() const { return {bodies, cell, planes, 1}; }
  void step(double dt) {
    const MotionSums moved = motion.advance(cell, Vec3(0, 0, -9.81), 0.2, dt, bodies);
    cell.advance(dt);
    if (neighbours.outdated(bodies, moved.fastest, 0, cell.velocity_gradient(), dt))
      neighbours.rebuild(bodies, cell, planes, contacts);
    sums = sweep->run(scene(), dt, contacts);
    sums.force_branch += motion.gather(contacts, bodies);
  }

  Bodies bodies;
  Cell cell;
  Planes planes;
  Contacts contacts;
  Neighbours neighbours;
  Motion motion;
  std::unique_ptr<ContactSweep> sweep;
  SweepSums sums;
};

bool same_bits(const std::vector<Lane4>& a, const std::vector<Lane4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Lane4)) == 0;
}

void expect_same_bits(const Model& model, const io::Snapshot& state) {
  Stepper four(state, model, make_contact_sweep_of_four), eight(state, model, make_contact_sweep_of_eight);
  double slid = 0;
  for (int k = 0; k < 150; ++k) four.step(2e-5), eight.step(2e-5), slid += four.sums.frictional;
  EXPECT_GT(slid, 0);
  for (const auto rows : {&Bodies::position, &Bodies::velocity, &Bodies::spin, &Bodies::force, &Bodies::torque})
    EXPECT_TRUE(same_bits(four.bodies.*rows, eight.bodies.*rows));
  EXPECT_EQ(std::memcmp(&four.sums, &eight.sums, sizeof four.sums), 0);
  EXPECT_EQ(four.sweep->stiffen(four.scene(), four.contacts), eight.sweep->stiffen(eight.scene(), eight.contacts));
  EXPECT_EQ(four.motion.stable_time_step(four.bodies, four.contacts),
            eight.motion.stable_time_step(eight.bodies, eight.contacts));
  const StoredEnergies a = four.sweep->stored(four.scene(), four.contacts);
  const StoredEnergies b = eight.sweep->stored(eight.scene(), eight.contacts);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST(SweepWidth, GivesTheSameBits) {
  expect_same_bits(testing::sand(), testing::packed(testing::sand(), 1e5, 300));
  expect_same_bits(testing::linear_sand(), testing::packed(testing::linear_sand(), 1e5, 300));
}

TEST(SweepWidth, GivesTheSameBitsWithSeveralMaterialsAndDamping) {
  auto rough = std::get<std::vector<HertzMindlin::Material>>(testing::sand().materials)[0];
  io::Snapshot state = testing::packed(testing::sand(), 1e5, 300);
  for (std::size_t i = 0; i < state.grains.size(); ++i) state.grains.material_id[i] = static_cast<int>(i % 3);
  auto smooth = rough, lossy = rough;
  smooth.friction_angle = 0.1, lossy.restitution = 0.5;
  expect_same_bits({std::vector<HertzMindlin::Material>{rough, smooth, lossy}}, state);
}

}  // namespace
}  // namespace soilweave::dem
