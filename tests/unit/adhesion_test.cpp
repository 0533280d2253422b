// Adhesion within a finite range: bodies act across a gap, in the sweep, in the neighbour lists and in the record.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "dem/contact/laws/linear_adhesion.h"
#include "support/impact.h"

namespace soilweave::dem {
namespace {

constexpr double radius = 1e-3, range = 2e-4, work = 0.5;  // m, m, J/m2

Model sticky() {
  LinearAdhesion::Material m;
  m.young_modulus = 1e7, m.stiffness_ratio = 0.5, m.friction_angle = 0.5;
  m.work_of_adhesion = work, m.adhesion_range = range;
  return {std::vector<LinearAdhesion::Material>{m, m, m}};
}

// Returns two spheres of density 1000 kg/m3 at rest, `gap` m apart.
io::Snapshot apart(double gap) {
  return test::scene({{radius, 1e3, Vec3::Zero(), Vec3::Zero()}, {radius, 1e3, {2 * radius + gap, 0, 0}, Vec3::Zero()}},
                     false);
}

TEST(Adhesion, PullsAcrossAGapAsMuchAsTheLawSays) {
  const Simulation simulation(apart(0.25 * range), sticky(), test::undamped(1e-7));
  const io::ContactsRecord contacts = simulation.snapshot().contacts;
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts.overlap[0], -0.25 * range, 1e-12 * radius);
  const double pull_off = 2 * std::numbers::pi * work * radius / 2;
  EXPECT_NEAR(contacts.normal_force[0], -0.75 * pull_off, 1e-9 * pull_off);
  EXPECT_EQ(contacts.shear_force[0].norm(), 0);
}

TEST(Adhesion, EndsAtItsRange) {
  Simulation simulation(apart(1.01 * range), sticky(), test::undamped(1e-7));
  for (int i = 0; i < 100; ++i) simulation.step();
  EXPECT_EQ(simulation.snapshot().contacts.size(), 0u);
  EXPECT_EQ(simulation.kinetic_energy(), 0);
}

// Grains that start at rest within the range meet, and go as far apart again; the balance of energies stays exact.
TEST(Adhesion, GivesBackWhatItTakes) {
  Simulation simulation(apart(0.9 * range), sticky(), test::undamped(2e-8));
  double deepest = -range, farthest = -range;
  const Bodies& bodies = simulation.bodies();
  for (int i = 0; i < 200000; ++i) {
    simulation.step();
    ASSERT_EQ(simulation.measures().contacts, 1) << "they left the range after step " << i;
    const Vec3 branch = vector_of(bodies.grains[1].position) - vector_of(bodies.grains[0].position);
    const double overlap = bodies.radius(0) + bodies.radius(1) - branch.norm();
    deepest = std::max(deepest, overlap);
    if (deepest > 0) farthest = std::max(farthest, -overlap);
    if (deepest > 0 && farthest > 0.89 * range) break;
  }
  EXPECT_GT(deepest, 0);
  EXPECT_GT(farthest, 0.89 * range);
  const Energies e = simulation.energies();
  ASSERT_GT(std::abs(e.initial()), 0) << "the energy of adhesion";
  EXPECT_LT(std::abs(e.error()), 1e-4 * std::abs(e.initial()));
}

TEST(Adhesion, IsRefusedWhereItReachesTwoImages) {
  io::Snapshot state = apart(0.9 * range);
  state.cell.matrix = Mat3::Identity() * 2 * (2 * radius + range) / 1.001;
  state.cell.periodic = {true, true, true};
  EXPECT_THROW(Simulation(state, sticky(), test::undamped(1e-7)), DataError);
  state.cell.matrix *= 1.002;
  EXPECT_NO_THROW(Simulation(state, sticky(), test::undamped(1e-7)));
}

// A list that was made before two grains came within range must hold their pair in time.
TEST(Adhesion, IsFeltByGrainsThatComeFromAfar) {
  io::Snapshot state = apart(6 * range);
  state.grains.velocity[0] = Vec3(0.5, 0, 0);
  Simulation simulation(state, sticky(), test::undamped(1e-7));
  double first = 0;
  for (int i = 0; i < 40000 && first == 0; ++i) {
    simulation.step();
    const io::ContactsRecord contacts = simulation.snapshot().contacts;
    if (contacts.size() > 0) first = contacts.overlap[0];
  }
  EXPECT_LT(first, 0);
  EXPECT_NEAR(first, -range, 2 * 0.5 * 1e-7) << "within the way of a step or two";
}

TEST(Adhesion, HoldsAGrainBelowAPlane) {
  io::Snapshot state = test::scene({{radius, 1e3, Vec3(0, 0, radius + 0.5 * range), Vec3::Zero()}}, true);
  const Simulation simulation(state, sticky(), test::undamped(1e-7));
  const io::ContactsRecord contacts = simulation.snapshot().contacts;
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts.bodies[0][1], -1);
  const double pull_off = 2 * std::numbers::pi * work * radius;
  EXPECT_NEAR(contacts.normal_force[0], -0.5 * pull_off, 1e-9 * pull_off);
}

}  // namespace
}  // namespace soilweave::dem
