// Promises of the engine: equal bits however it is run, energy accounted for, stress that does the work it claims.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/error.h"
#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"
#include "dem/loading/path.h"
#include "packing/expand/tile.h"
#include "support/assemblies.h"

namespace soilweave::dem {
namespace {

bool same(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

void expect_same_state(const io::Snapshot& a, const io::Snapshot& b) {
  EXPECT_TRUE(same(a.grains.position, b.grains.position));
  EXPECT_TRUE(same(a.grains.velocity, b.grains.velocity));
  EXPECT_TRUE(same(a.grains.angular_velocity, b.grains.angular_velocity));
  EXPECT_EQ(a.contacts.bodies, b.contacts.bodies);
  EXPECT_TRUE(same(a.contacts.shear_force, b.contacts.shear_force));
  EXPECT_TRUE(same(a.contacts.rolling_moment, b.contacts.rolling_moment));
  EXPECT_EQ(a.contacts.normal_force, b.contacts.normal_force);
}

Mat3 shearing() {
  Mat3 gradient = Mat3::Zero();
  gradient.diagonal() = Vec3(0.05, 0.05, -0.1);
  gradient(0, 2) = 0.02;
  return gradient;
}

// Returns 2100 grains, three chunks: copies of 700 along x, perturbed so that no two move alike.
io::Snapshot several_chunks() {
  io::Snapshot all = packing::tile(support::packed(support::sand(), 1e5, 700), {3, 1, 1}, {true, true, true});
  io::GrainsRecord& g = all.grains;
  for (std::size_t i = 0; i < g.size(); ++i)
    g.position[i][static_cast<int>(i % 3)] += 1e-5 * g.copy_id[i] * g.radius[i];
  return all;
}

TEST(Simulation, GivesTheSameBitsOnAnyNumberOfThreads) {
  const io::Snapshot start = several_chunks();
  Numerics many;
  many.threads = 3;
  Simulation one(start, support::sand(), {}), three(start, support::sand(), many);
  for (Simulation* s : {&one, &three}) s->set_velocity_gradient(shearing());
  for (int k = 0; k < 200; ++k) one.step(), three.step();
  expect_same_state(one.snapshot(), three.snapshot());
  EXPECT_EQ(one.measures().stress, three.measures().stress);
  many.threads = 16;
  Simulation sixteen(start, support::sand(), many);
  sixteen.set_velocity_gradient(shearing());
  for (int k = 0; k < 200; ++k) sixteen.step();
  expect_same_state(one.snapshot(), sixteen.snapshot());
}

// A new simulation evaluates the stiffness at once; the other one does so at multiples of this number of steps.
constexpr int between_looks = 32;

TEST(Simulation, GoesOnFromASnapshotBitByBit) {
  for (const Model& model : {support::sand(), support::linear_sand()}) {
    Simulation whole(support::packed(model, 1e5), model, {});
    whole.set_velocity_gradient(shearing());
    for (int k = 0; k < 10 * between_looks; ++k) whole.step();
    Simulation resumed(whole.snapshot(), model, {});
    EXPECT_EQ(whole.measures().stress, resumed.measures().stress);
    EXPECT_EQ(whole.unbalanced_force(), resumed.unbalanced_force());
    for (int k = 0; k < 304; ++k) whole.step(), resumed.step();
    expect_same_state(whole.snapshot(), resumed.snapshot());
  }
}

// The energy balance allows 1e-3 of the work; the error of time stepping is of second order. A resumed simulation has
// another list than a new one: with several chunks of grains, and contacts at other places in their blocks, sums must
// still be equal.
TEST(Simulation, GoesOnFromASnapshotBitByBitWithSeveralChunks) {
  Simulation whole(several_chunks(), support::sand(), {});
  whole.set_velocity_gradient(shearing());
  for (int k = 0; k < 3 * between_looks; ++k) whole.step();
  Simulation resumed(whole.snapshot(), support::sand(), {});
  for (int k = 0; k < 400; ++k) whole.step(), resumed.step();
  expect_same_state(whole.snapshot(), resumed.snapshot());
  EXPECT_EQ(whole.measures().stress, resumed.measures().stress);
  EXPECT_EQ(whole.measures().axial_stiffness, resumed.measures().axial_stiffness);
}

TEST(Simulation, LanesOfSeveralMaterialsAnswerLikeOne) {
  const io::Snapshot start = support::packed(support::sand(), 1e5);
  const auto material = support::sand().materials.of<HertzMindlin::Material>()[0];
  io::Snapshot mixed = start;
  for (std::size_t i = 0; i < mixed.grains.size(); ++i)
    mixed.grains.material_id[i] = static_cast<int>((7 * i + i / 5) % 3);
  Simulation one(start, support::sand(), {});
  Simulation three(mixed, {std::vector<HertzMindlin::Material>{material, material, material}}, {});
  auto slippery = material;
  slippery.friction_angle = 0.1;
  Simulation other(mixed, {std::vector<HertzMindlin::Material>{material, material, slippery}}, {});
  for (Simulation* s : {&one, &three}) {
    s->set_velocity_gradient(shearing());
    for (int k = 0; k < 200; ++k) s->step();
  }
  for (int k = 0; k < 20; ++k) other.step();
  // Pairs are swept by pair of materials, so sums over them are made in another order.
  const io::Snapshot of_one = one.snapshot(), of_three = three.snapshot();
  ASSERT_EQ(of_one.contacts.bodies, of_three.contacts.bodies);
  const double mean = std::accumulate(of_one.contacts.normal_force.begin(), of_one.contacts.normal_force.end(), 0.0) /
                      static_cast<double>(of_one.contacts.size());
  for (std::size_t k = 0; k < of_one.contacts.size(); ++k) {
    EXPECT_NEAR(of_one.contacts.normal_force[k], of_three.contacts.normal_force[k], 1e-9 * mean);
    EXPECT_LE((of_one.contacts.shear_force[k] - of_three.contacts.shear_force[k]).norm(), 1e-9 * mean);
  }
  const io::Snapshot end = other.snapshot();
  std::size_t found = 0;
  for (std::size_t k = 0; k < end.contacts.size(); ++k) {
    const auto [i, j] = std::pair(end.contacts.bodies[k][0], end.contacts.bodies[k][1]);
    const bool smooth = mixed.grains.material_id[static_cast<std::size_t>(i)] == 2 ||
                        mixed.grains.material_id[static_cast<std::size_t>(j)] == 2;
    if (!smooth) continue;
    ++found;
    EXPECT_LE(end.contacts.shear_force[k].norm(), 1.0001 * std::tan(0.1) * end.contacts.normal_force[k]);
  }
  EXPECT_GT(found, 20u);
}

TEST(Simulation, TurnsAGrainByItsSpin) {
  io::Snapshot state = support::packed(support::sand(), 1e5, 20);
  state.contacts = {};
  state.cell.matrix *= 10;
  for (Vec3& x : state.grains.position) x *= 10;
  const Vec3 spin(3, -2, 6);
  for (Vec3& w : state.grains.angular_velocity) w = spin;
  for (Vec4& q : state.grains.orientation) q = Vec4(1, 0, 0, 0);
  Numerics fixed;
  fixed.time_step = 1e-4;
  Simulation s(state, support::sand(), fixed);
  for (int k = 0; k < 2000; ++k) s.step();
  const double half = 0.5 * spin.norm() * s.time();
  const Vec3 axis = std::sin(half) * spin.normalized();
  const Vec4 expected(std::cos(half), axis.x(), axis.y(), axis.z());
  const Vec4 q = s.snapshot().grains.orientation[0];
  EXPECT_NEAR(q.norm(), 1, 1e-14);
  // First order in the step: (dt w/2)^2/3 of the angle.
  EXPECT_LT((q - expected).norm(), 1e-6);
}

// The disk turns by more than a full turn, from its initial angle.
TEST(Simulation, TurnsADiskByItsSpin) {
  io::Snapshot state = support::packed(support::sand(), 1e5, 20, 2);
  state.contacts = {};
  state.cell.matrix.topLeftCorner<2, 2>() *= 10;
  for (Vec3& x : state.grains.position) x *= 10;
  for (Vec3& w : state.grains.angular_velocity) w = Vec3(0, 0, -40);
  for (Vec4& q : state.grains.orientation) q = Vec4(std::cos(0.3), 0, 0, std::sin(0.3));
  Numerics fixed;
  fixed.time_step = 1e-4;
  Simulation s(state, support::sand(), fixed);
  for (int k = 0; k < 2000; ++k) s.step();
  const double half = 0.3 - 20 * s.time();
  for (const Vec4& q : s.snapshot().grains.orientation)
    EXPECT_LT((q - Vec4(std::cos(half), 0, 0, std::sin(half))).norm(), 1e-12);
  const io::Snapshot turned = s.snapshot();
  EXPECT_LT((Simulation(turned, support::sand(), fixed).snapshot().grains.orientation[0] - turned.grains.orientation[0])
                .norm(),
            1e-15);
}

TEST(Simulation, ClosesTheEnergyBalanceOfATriaxialTest) {
  for (const Model& model : {support::sand(), support::linear_sand()}) {
    Simulation s(support::packed(model, 2e5), model, {});
    s.set_reference();
    Servo servo;
    const AxisGoal lateral{AxisGoal::Kind::stress, 2e5, 1.0};
    const AxisGoals goals{lateral, lateral, AxisGoal{AxisGoal::Kind::strain, 0.05, 0.1}};
    while (s.strain().z() < 0.05 - 1e-9) {
      servo.drive(goals, 3, s);
      s.step();
    }
    const Energies e = s.energies();
    EXPECT_GT(e["boundary_work"], 0);
    EXPECT_GT(e["frictional"], 0.1 * e["boundary_work"]);
    EXPECT_GT(e["damping"], 0);
    EXPECT_GE(e["rolling_plastic"], 0);
    EXPECT_LT(std::abs(e.error()), 3e-4 * e["boundary_work"]);  // of second order in the step; the error is 1e-4
    // The balance accepts any friction, since the law's own energy is the remainder of the work on its springs. That
    // energy must therefore be small by itself. Linear: the law slips by full radii, the surfaces by the overlap less,
    // 1e-3 of them. Hertz: a spring sheared while its overlap falls keeps its force, not its energy (2.6 %).
    const bool is_linear = model.materials.are<Linear::Material>();
    EXPECT_LT(std::abs(e["law"]), (is_linear ? 3e-3 : 0.04) * e["boundary_work"]);
  }
}

// Without friction the elastic energy is a potential of the positions, so the work of a small affine stretch is its
// change.
TEST(Simulation, StressIsTheDerivativeOfTheElasticEnergy) {
  const io::Snapshot start = support::packed(support::sand(0), 1e5);
  const auto energy_and_stress = [&](double strain, int axis) {
    io::Snapshot moved = start;
    Mat3 stretch = Mat3::Identity();
    stretch(axis, axis) += strain;
    for (Vec3& x : moved.grains.position) x = (stretch * x).eval();
    for (Vec3& v : moved.grains.velocity) v.setZero();
    moved.cell.matrix = (stretch * moved.cell.matrix).eval();
    moved.contacts = {};
    const Simulation s(moved, support::sand(0), {});
    return std::pair(s.energies()["elastic_normal"], s.measures().stress(axis, axis));
  };
  for (int axis = 0; axis < 3; ++axis) {
    const double h = 1e-8, volume = start.cell.matrix.diagonal().prod();
    const double slope = (energy_and_stress(-h, axis).first - energy_and_stress(h, axis).first) / (2 * h * volume);
    EXPECT_NEAR(slope / energy_and_stress(0, axis).second, 1, 1e-6) << "axis " << axis;
  }
}

TEST(Simulation, KeepsMomentumWithoutDamping) {
  Numerics free;
  free.damping = 0;
  Simulation s(support::packed(support::sand(), 1e5), support::sand(), free);
  for (int k = 0; k < 500; ++k) s.step();
  const io::Snapshot end = s.snapshot();
  Vec3 momentum = Vec3::Zero();
  double size = 0;
  for (std::size_t i = 0; i < end.grains.size(); ++i) {
    momentum += end.grains.mass[i] * end.grains.velocity[i];
    size += end.grains.mass[i] * end.grains.velocity[i].norm();
  }
  const io::Snapshot start = support::packed(support::sand(), 1e5);
  for (std::size_t i = 0; i < start.grains.size(); ++i) momentum -= start.grains.mass[i] * start.grains.velocity[i];
  EXPECT_LT(momentum.norm(), 1e-9 * size);
}

TEST(Simulation, RigidRotationOfTheCellStrainsNothing) {
  io::Snapshot start = support::packed(support::sand(), 1e5);
  const Simulation before(start, support::sand(), {});
  const Mat3 stress = before.measures().stress;
  const double angle = 0.7;
  Mat3 turn = Mat3::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (auto* field : {&start.grains.position, &start.grains.velocity, &start.grains.angular_velocity,
                      &start.contacts.normal, &start.contacts.shear_force, &start.contacts.rolling_moment})
    for (Vec3& v : *field) v = (turn * v).eval();
  start.cell.matrix = (turn * start.cell.matrix).eval();
  const Simulation after(start, support::sand(), {});
  EXPECT_LT((after.measures().stress - turn * stress * turn.transpose()).norm(), 1e-9 * stress.norm());
}

TEST(Simulation, DisksStayInTheirPlane) {
  Simulation s(support::packed(support::linear_sand(), 1e3, 200, 2), support::linear_sand(), {});
  Mat3 gradient = Mat3::Zero();
  gradient(0, 0) = 0.05, gradient(1, 1) = -0.05;
  s.set_velocity_gradient(gradient);
  for (int k = 0; k < 500; ++k) s.step();
  const io::Snapshot end = s.snapshot();
  for (std::size_t i = 0; i < end.grains.size(); ++i) {
    EXPECT_EQ(end.grains.position[i].z(), 0);
    EXPECT_EQ(end.grains.angular_velocity[i].x(), 0);
    EXPECT_EQ(end.grains.angular_velocity[i].y(), 0);
  }
  EXPECT_GT(s.measures().stress(1, 1), s.measures().stress(0, 0));
  EXPECT_EQ(s.measures().stress(2, 2), 0);
}

TEST(Simulation, StopsWhenGrainsPassThroughEachOther) {
  Simulation s(support::packed(support::sand(), 1e5), support::sand(), {});
  Mat3 crush = -50 * Mat3::Identity();
  s.set_velocity_gradient(crush);
  try {
    for (int k = 0; k < 100000; ++k) s.step();
    FAIL() << "nothing stopped it";
  } catch (const PhysicsError& e) {
    EXPECT_NE(std::string(e.what()).find("step "), std::string::npos) << e.what();
  }
}

TEST(Simulation, TellsTheMotionOfWhatIsActedOnFromFreeFlight) {
  io::Snapshot state = support::packed(support::sand(), 1e5);
  std::vector<int> contacts(state.grains.size(), 0);
  for (const auto& [a, b] : state.contacts.bodies)
    ++contacts[static_cast<std::size_t>(a)], ++contacts[static_cast<std::size_t>(b)];
  const auto floating = static_cast<std::size_t>(std::find(contacts.begin(), contacts.end(), 0) - contacts.begin());
  const auto held = static_cast<std::size_t>(std::max_element(contacts.begin(), contacts.end()) - contacts.begin());
  ASSERT_LT(floating, contacts.size());
  state.grains.velocity[floating] = state.grains.velocity[held] = Vec3::Zero();
  const Simulation before(state, support::sand(), {});
  state.grains.velocity[floating] = Vec3(1e-3, 0, 0);
  const Simulation flying(state, support::sand(), {});
  EXPECT_GT(flying.kinetic_energy(), before.kinetic_energy());
  EXPECT_EQ(flying.kinetic_energy_of_acted_on(), before.kinetic_energy_of_acted_on());
  state.grains.velocity[held] = Vec3(1e-3, 0, 0);
  EXPECT_GT(Simulation(state, support::sand(), {}).kinetic_energy_of_acted_on(), before.kinetic_energy_of_acted_on());
}

TEST(Simulation, ScaledRadiiKeepDensityAndCountTheWork) {
  Simulation s(support::packed(support::sand(), 1e5), support::sand(), {});
  const double solids = s.solid_volume(), stress = s.measures().stress(0, 0);
  s.scale_radii(1.0005);
  EXPECT_NEAR(s.solid_volume() / solids, std::pow(1.0005, 3), 1e-12);
  for (int k = 0; k < 8; ++k) s.step();
  EXPECT_GT(s.measures().stress(0, 0), stress);
  EXPECT_LT(std::abs(s.energies().error()), 1e-3 * s.energies().stored());
}

TEST(Servo, HoldsStressesAndVolume) {
  const Model model = support::sand();
  Simulation s(support::packed(model, 1e5), model, {});
  Servo servo;
  const AxisGoals goals{AxisGoal{AxisGoal::Kind::stress, 1.2e5, 1}, AxisGoal{AxisGoal::Kind::stress, 1.0e5, 1},
                        AxisGoal{AxisGoal::Kind::stress, 1.4e5, 1}};
  const Tolerances tolerances;
  int steps = 0;
  for (; steps < 20000 && !Servo::settled(goals, 3, tolerances, s); ++steps) {
    servo.drive(goals, 3, s);
    s.step();
  }
  EXPECT_LT(steps, 20000);
  EXPECT_NEAR(s.measures().stress(2, 2), 1.4e5, 1.4e2);
  EXPECT_LE(s.unbalanced_force(), 1e-3);
}

// The servo's own period is 126 steps (control.cpp) for any number of grains, and four of them reach a doubled
// pressure. The strain rate of an axis grows by error/mass; damping cuts it where it already points to the goal.
TEST(Servo, OfInertiaAcceleratesTheCellByErrorOverMass) {
  Simulation s(support::packed(support::sand(), 1e5), support::sand(), {});
  Servo servo({ServoRule::Kind::inertia, 0.25});
  const double goal = s.measures().stress(0, 0) + 1e4;
  const AxisGoal up{AxisGoal::Kind::stress, goal, 1}, still{AxisGoal::Kind::strain, 0, 1};
  double rate = 0;
  for (int k = 0; k < 3; ++k) {
    const double error = goal - s.measures().stress(0, 0);
    rate += (k == 0 ? 1 : 0.75) * s.time_step() * error / s.mass();
    const double before = s.strain()[0], dt = s.time_step();
    servo.drive({up, still, still}, 3, s);
    s.step();
    EXPECT_NEAR((s.strain()[0] - before) / dt, -std::log1p(-rate * dt) / dt, 1e-9 * rate) << "step " << k;
  }
}

TEST(Servo, NeedsNoMoreStepsForMoreGrains) {
  for (const std::size_t grains : {125U, 1000U}) {
    Simulation s(support::packed(support::sand(), 1e5, grains), support::sand(), {});
    Servo servo;
    const AxisGoal goal{AxisGoal::Kind::stress, 2e5, 1};
    int steps = 0;
    while (std::abs(s.measures().stress(0, 0) - 2e5) > 2e2 && steps < 10000) {
      servo.drive({goal, goal, goal}, 3, s);
      s.step();
      ++steps;
    }
    EXPECT_LT(steps, 4 * 126) << grains << " grains";
  }
}

}  // namespace
}  // namespace soilweave::dem
