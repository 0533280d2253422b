// Eight contacts and grains at a time give the bits of four, and so do other lists of distant pairs.
// Sweeps in the plane give the numbers of sweeps in space.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear_adhesion.h"
#include "support/assemblies.h"
#include "support/engine_parts.h"
#include "support/worse.h"

namespace soilweave::dem {
namespace {

using support::same_bits;

// The sweep of eight from the same source as for AVX-512, lowered to the baseline (Makefile).
struct Width {
  std::unique_ptr<ContactSweep> (*sweep)(const Model&);
  GrainMotion (*motion)();
};
constexpr Width of_four{make_contact_sweep_of_four, grain_motion_of_four};
constexpr Width of_eight{make_contact_sweep_of_eight, grain_motion_of_eight};

// Grains in a shearing cell, stepped by hand.
struct Stepper : support::EngineParts {
  Stepper(const io::Snapshot& state, const Model& model, const Width& width)
      : EngineParts(state, width.sweep(model), 1, width.motion()) {
    cell.set_velocity_gradient(bodies.dimension == 3 ? Mat3(Vec3(-0.2, 0.1, -0.3).asDiagonal()) : shearing());
    act(0);
  }
  static Mat3 shearing() {
    Mat3 gradient = Vec3(-0.2, 0.1, 0).asDiagonal();
    gradient(0, 1) = 0.1;
    return gradient;
  }
  void step(double dt) {
    const int dimension = bodies.dimension;
    const Vec3 gravity = dimension == 3 ? Vec3(0, 0, -9.81) : Vec3(0, -9.81, 0);
    if (in_space) bodies.dimension = 3;
    motion.set_out(cell, gravity, 0.2, dt, bodies);
    motion.advance_all(bodies);
    bodies.dimension = dimension;
    cell.advance(dt);
    planes.advance(dt);
    const double fastest = planes.all.empty() ? 0 : planes.all.front().velocity.norm();
    if (neighbours.outdated(bodies, motion.advanced().skin_rate, fastest, cell.velocity_gradient(), dt))
      neighbours.rebuild(bodies, cell, planes, contacts);
    if (in_space) bodies.dimension = 3;
    act(dt);
    bodies.dimension = dimension;
  }

  // Adds a plane from below that lifts the lowest ten grains and drags them along.
  void press() {
    const int up = bodies.dimension - 1;
    std::vector<double> lowest;
    for (const Grain& g : bodies.grains) lowest.push_back(g.position[up] - g.position[3]);
    std::nth_element(lowest.begin(), lowest.begin() + 10, lowest.end());
    Vec3 velocity = 1e-2 * Vec3::Unit(up);
    velocity[0] = 2e-2;
    planes.all = {{lowest[10] * Vec3::Unit(up), Vec3::Unit(up), velocity, 0}};
    neighbours.rebuild(bodies, cell, planes, contacts);
  }

  // Moves disks as if they were spheres.
  void lift() {
    in_space = true;
    for (Grain& g : bodies.grains) {
      g.spin[2] = g.velocity[2];
      g.velocity[2] = 0;
    }
  }

  bool in_space = false;
};

void expect_same_bits(const Model& model, const io::Snapshot& state, bool with_plane = false) {
  Stepper four(state, model, of_four), eight(state, model, of_eight);
  if (with_plane) four.press(), eight.press();
  double slid = 0;
  for (int k = 0; k < 150; ++k) {
    four.step(2e-5), eight.step(2e-5);
    slid += four.sums.frictional;
    const MotionSums a = four.motion.advanced(), b = eight.motion.advanced();
    ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << "step " << k;
  }
  EXPECT_GT(slid, 0);
  EXPECT_EQ(four.sums.plane_work != 0, with_plane);
  EXPECT_TRUE(std::isfinite(four.sums.force_branch.sum()));
  EXPECT_TRUE(same_bits(four.bodies.grains, eight.bodies.grains));
  EXPECT_TRUE(same_bits(four.bodies.angle, eight.bodies.angle));
  EXPECT_TRUE(same_bits(four.bodies.loads, eight.bodies.loads));
  EXPECT_EQ(std::memcmp(&four.sums, &eight.sums, sizeof four.sums), 0);
  EXPECT_EQ(four.sweep->stiffen(four.scene(), four.contacts), eight.sweep->stiffen(eight.scene(), eight.contacts));
  EXPECT_TRUE(same_bits(four.bodies.stiffness, eight.bodies.stiffness));
  EXPECT_EQ(four.motion.stable_time_step(four.contacts, four.bodies),
            eight.motion.stable_time_step(eight.contacts, eight.bodies));
  const StoredEnergies a = four.sweep->stored(four.scene(), four.contacts);
  const StoredEnergies b = eight.sweep->stored(eight.scene(), eight.contacts);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST(SweepWidth, GivesTheSameBits) {
  // The numbers of grains are no multiples of eight or four.
  expect_same_bits(support::sand(), support::packed(support::sand(), 1e5, 303));
  expect_same_bits(support::linear_sand(), support::packed(support::linear_sand(), 1e5, 301));
  expect_same_bits(support::linear_sand(), support::packed(support::linear_sand(), 1e5, 302, 2));
}

TEST(SweepWidth, GivesTheSameBitsWithAPlane) {
  expect_same_bits(support::sand(), support::packed(support::sand(), 1e5, 303), true);
  expect_same_bits(support::linear_sand(), support::packed(support::linear_sand(), 1e5, 302, 2), true);
}

TEST(SweepWidth, GivesTheSameBitsWithSeveralMaterialsAndDamping) {
  auto rough = support::sand().materials.of<HertzMindlin::Material>()[0];
  io::Snapshot state = support::packed(support::sand(), 1e5, 300);
  for (std::size_t i = 0; i < state.grains.size(); ++i) state.grains.material_id[i] = static_cast<int>(i % 3);
  auto smooth = rough, lossy = rough;
  smooth.friction_angle = 0.1, lossy.restitution = 0.5;
  expect_same_bits({std::vector<HertzMindlin::Material>{rough, smooth, lossy}}, state);
}

TEST(SweepWidth, GivesTheSameBitsAcrossGaps) {
  LinearAdhesion::Material moist;
  static_cast<Linear::Material&>(moist) = support::linear_sand().materials.of<Linear::Material>()[0];
  moist.work_of_adhesion = 0.1, moist.adhesion_range = 1e-4;
  const Model model{std::vector<LinearAdhesion::Material>{moist}};
  expect_same_bits(model, support::packed(support::linear_sand(), 1e5, 301), true);
  expect_same_bits(model, support::packed(support::linear_sand(), 1e5, 302, 2));
}

// Lists the pairs that touch and no others, as a list made anew may.
void list_touching_alone(Stepper& stepper) {
  std::vector<Pair> touching;
  for (const auto& chunk : stepper.contacts.chunks)
    for (const ContactBlock& block : chunk)
      for (int lane = 0; lane < block.count; ++lane)
        if ((block.touching >> lane) & 1) touching.push_back(stepper.contacts.pair(block, lane));
  stepper.contacts.list(touching, {}, stepper.bodies);
}

std::size_t pairs_of(const Contacts& contacts) {
  std::size_t pairs = 0;
  for (const auto& chunk : contacts.chunks)
    for (const ContactBlock& block : chunk) pairs += block.count;
  return pairs;
}

TEST(SumsOfASweep, HaveTheSameBitsWhateverDistantPairsAreListed) {
  // Fewer grains than a chunk holds, so that each grain has one sum of its stiffness.
  for (const Model& model : {support::sand(), support::linear_sand()})
    for (const int dimension : {2, 3}) {
      const io::Snapshot state = support::packed(model, 1e5, 301, dimension);
      Stepper many(state, model, of_four), few(state, model, of_four);
      for (int k = 0; k < 20; ++k) many.step(1e-5), few.step(1e-5);
      list_touching_alone(few);
      ASSERT_LT(pairs_of(few.contacts), pairs_of(many.contacts));
      Vec3 of_many, of_few;
      many.act(1e-5, false, &of_many), few.act(1e-5, false, &of_few);
      EXPECT_EQ(of_few, of_many);
      EXPECT_TRUE(same_bits(few.bodies.stiffness, many.bodies.stiffness));
      EXPECT_TRUE(same_bits(few.bodies.grains, many.bodies.grains));
      EXPECT_EQ(std::memcmp(&few.sums, &many.sums, sizeof few.sums), 0);
      const StoredEnergies a = few.sweep->stored(few.scene(), few.contacts);
      const StoredEnergies b = many.sweep->stored(many.scene(), many.contacts);
      EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
      EXPECT_EQ(force_sum(few.contacts), force_sum(many.contacts));
    }
}

TEST(StiffnessOfAStep, IsWhatALookAtTheStateAfterItFinds) {
  for (const Model& model : {support::sand(), support::linear_sand()})
    for (const int dimension : {2, 3}) {
      Stepper stepper(support::packed(model, 1e5, 300, dimension), model, of_four);
      for (int k = 0; k < 20; ++k) stepper.step(1e-5);
      Vec3 with_step;
      stepper.act(1e-5, false, &with_step);
      const double limit = stepper.motion.stable_time_step(stepper.contacts, stepper.bodies);
      EXPECT_EQ(stepper.sweep->stiffen(stepper.scene(), stepper.contacts), with_step);
      EXPECT_EQ(stepper.motion.stable_time_step(stepper.contacts, stepper.bodies), limit);
      EXPECT_TRUE(std::isfinite(limit));
      EXPECT_GT(with_step[0], 0);
      EXPECT_GT(with_step[1], 0);
      // The stiffness is used up, so the next evaluation begins with none.
      EXPECT_EQ(stepper.motion.stable_time_step(stepper.contacts, stepper.bodies),
                std::numeric_limits<double>::infinity());
      // Disks have no stiffness normal to their plane that could bound the step.
      if (dimension == 3) continue;
      stepper.bodies.dimension = 3;
      stepper.sweep->stiffen(stepper.scene(), stepper.contacts);
      EXPECT_EQ(stepper.motion.stable_time_step(stepper.contacts, stepper.bodies), limit);
      stepper.bodies.dimension = 2;
    }
}

// Shear forces are numbers in the plane and vectors in space, rotated to the third order of a pair's motion in a step.
TEST(SweepInThePlane, GivesTheNumbersOfTheSweepInSpace) {
  constexpr double rounding = 1e-9;
  auto lossy = support::sand().materials.of<HertzMindlin::Material>()[0];
  lossy.restitution = 0.5;
  for (const Model& model :
       {support::sand(), support::linear_sand(), Model{std::vector<HertzMindlin::Material>{lossy}}}) {
    const io::Snapshot state = support::packed(model, 1e5, 300, 2);
    Stepper plane(state, model, of_four), space(state, model, of_four);
    space.lift();
    double slid = 0;
    for (int k = 0; k < 100; ++k) plane.step(1e-5), space.step(1e-5), slid += plane.sums.frictional;
    EXPECT_GT(slid, 0);
    // Returns the largest difference over the largest value of all grains.
    const auto differ = [&](const auto& in_plane, const auto& in_space) {
      double difference = 0, largest = 0;
      for (std::size_t i = 0; i < plane.bodies.size(); ++i) {
        const Vec3 a = vector_of(in_plane(i)), b = vector_of(in_space(i));
        difference = soilweave::test::worse(difference, (a - b).norm()), largest = std::max(largest, b.norm());
      }
      return difference / largest;
    };
    const auto& p = plane.bodies;
    const auto& s = space.bodies;
    EXPECT_LT(differ([&](auto i) { return p.grains[i].position; }, [&](auto i) { return s.grains[i].position; }),
              rounding);
    EXPECT_LT(differ([&](auto i) { return p.spin(i); }, [&](auto i) { return s.grains[i].spin; }), rounding);
    EXPECT_LT(differ([&](auto i) { return p.force(i); }, [&](auto i) { return s.loads[i].force; }), rounding);
    EXPECT_LT(differ([&](auto i) { return p.torque(i); }, [&](auto i) { return s.loads[i].torque; }), rounding);
    EXPECT_LT((plane.sums.force_branch - space.sums.force_branch).norm(), rounding * space.sums.force_branch.norm());
    EXPECT_NEAR(plane.sums.tangential_work, space.sums.tangential_work,
                rounding * std::abs(space.sums.tangential_work));
    EXPECT_NEAR(plane.sums.frictional, space.sums.frictional, rounding * space.sums.frictional);
  }
}

}  // namespace
}  // namespace soilweave::dem
