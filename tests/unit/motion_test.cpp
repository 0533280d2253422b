// One step of a few grains against closed forms: their new positions, the lost energy, and the length of the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dem/contact/laws/linear.h"
#include "dem/contact/pair_geometry.h"
#include "support/assemblies.h"
#include "support/engine_parts.h"
#include "support/impact.h"

namespace soilweave::dem {
namespace {

using test::scene;
using test::Sphere;
using test::undamped;

constexpr double R = 0.01, density = 2650, E = 1e8;

Model linear(double stiffness_ratio, double mu = 0, std::optional<double> e = {}) {
  const Linear::Material m{E, stiffness_ratio, std::atan(mu), e, {}, {}};
  return {std::vector<Linear::Material>{m, m, m}};
}

Sphere free_sphere(const Vec3& velocity = Vec3::Zero()) { return {R, density, Vec3(0.03, 0.05, 0.07), velocity}; }
const double mass = free_sphere().mass();

// Positions become x + dt (L x + v): each of the nine numbers of L moves one coordinate along another.
TEST(Motion, AGrainGoesWithItsCellAndByItsOwnVelocity) {
  const double dt = 1e-3;
  const Vec3 v(1, -2, 3), x = free_sphere().position;
  Simulation simulation(scene({free_sphere(v)}, false), linear(0), undamped(dt));
  Mat3 gradient;
  gradient << 0.1, 0.2, -0.3, 0.4, -0.5, 0.6, -0.7, 0.8, 0.9;
  simulation.set_velocity_gradient(gradient);
  simulation.step();
  EXPECT_LT((simulation.snapshot().grains.position[0] - (x + dt * (gradient * x + v))).norm(), 1e-16);
}

// Branches d become (1 + dt L) d in a step: seen from the new branch they moved by L d, to second order in dt L.
TEST(Motion, ThePairsOfACellMoveAsTheirBranchesDid) {
  Mat3 gradient;
  gradient << 0.1, 0.2, -0.3, 0.4, -0.5, 0.6, -0.7, 0.8, 0.9;
  const Vec3 before(1, -2, 3);
  const auto error = [&](double dt) {
    const Vec3 after = before + dt * gradient * before;
    const V3<double> seen = AffineMotion(gradient, true, dt)(from_eigen(after));
    return (to_eigen(seen) - gradient * before).norm();
  };
  EXPECT_NEAR(error(0.01) / error(0.005), 4, 0.1);
  const Mat3 diagonal = Vec3(0.1, -0.2, 0.3).asDiagonal();
  const Vec3 after = before + 1e-4 * diagonal * before;
  EXPECT_LT((to_eigen(AffineMotion(diagonal, true, 1e-4)(from_eigen(after))) - diagonal * before).norm(), 1e-9);
}

// Local damping takes from a force that speeds a grain up and adds to one that slows it. The work of the undamped force
// over the step decides which, even if the grain turns back within it.
TEST(Motion, DampingGoesByTheWorkOfTheForceOverTheStep) {
  const double dt = 1e-3, g = 10, part = 0.4;
  for (const double share : {-2.0, -1.0, -0.8, -0.6, -0.4, -0.2, 0.0, 0.3, 1.0}) {
    Numerics numerics = undamped(dt, g);
    numerics.damping = part;
    const double before = -share * g * dt;  // share of the speed that gravity adds in a step, downwards
    Simulation simulation(scene({free_sphere(Vec3(0, 0, before))}, false), linear(0), numerics);
    simulation.step();
    // Half of the speed that the undamped force would add decides.
    const double kept = share + 0.5 < 0 ? 1 + part : 1 - part;
    const double after = before - kept * g * dt;
    EXPECT_NEAR(simulation.snapshot().grains.velocity[0].z(), after, 1e-15) << share;
    const Energies e = simulation.energies();
    EXPECT_NEAR(e["damping"], 0.5 * (1 - kept) * -mass * g * (before + after) * dt, 1e-15 * mass) << share;
    EXPECT_NEAR(e["gravity_work"], 0.5 * -mass * g * (before + after) * dt, 1e-15 * mass) << share;
  }
}

// The lighter of two touching grains changes its speed by the whole bound if it moves against its force and gravity.
TEST(Motion, NoGrainGainsMoreThanTheBoundAndOneGainsAllOfIt) {
  const double dt = 1e-6, g = 10, damping = 0.3;
  const Sphere low = free_sphere(Vec3(0, 0, 5));
  Sphere high = low;
  high.radius = 1.5 * R, high.position.z() += 2.49 * R;
  support::EngineParts parts(scene({low, high}, false), make_contact_sweep(linear(0.5)));
  parts.act(0);
  const double force = norm(V3<double>{parts.bodies.force(0)[0], parts.bodies.force(0)[1], parts.bodies.force(0)[2]});
  ASSERT_GT(force, 1);
  parts.motion.set_out(parts.cell, Vec3(0, 0, -g), damping, dt, parts.bodies);
  const double bound = parts.motion.gain_bound(parts.bodies.smallest_mass());
  EXPECT_NEAR(bound, dt * (1 + damping) * (force / low.mass() + g), 1e-12 * bound);
  parts.motion.advance_all(parts.bodies);
  EXPECT_NEAR(5 - vector_of(parts.bodies.velocity(0)).z(), bound, 1e-9 * bound);
  EXPECT_LT(std::abs(5 - vector_of(parts.bodies.velocity(1)).z()), bound);
}

// Limits are sqrt(2 m/k) of translation, sqrt(2 I/(ks R^2)) of rotation, and sqrt(2 m/(4 kn)) of a grain between
// contacts to come. With I = 2/5 m R^2 rotation rules if ks > 1.6 kn.
TEST(Motion, RotationBoundsTheStepWhereShearIsStiff) {
  const double kn = E * R;
  const Sphere low = free_sphere();
  const auto limit = [&](double ratio, int axis) {
    Sphere other = low;
    other.position[axis] += 1.999 * R;
    Simulation simulation(scene({low, other}, false), linear(ratio), {});
    return simulation.stability_limit();
  };
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(limit(4, axis), std::sqrt(2 * 0.4 * mass / (4 * kn)), 1e-9 * limit(4, axis)) << axis;
    EXPECT_NEAR(limit(0.5, axis), std::sqrt(2 * mass / (4 * kn)), 1e-9 * limit(0.5, axis)) << axis;
  }
}

// ---- The shear force of a contact turns with its grains: about the normal by their mean spin.

// Returns the direction of the shear force, along x before, after a step in which the grains spin about z.
Vec3 turned_shear(const std::vector<Sphere>& spheres, bool plane, double dt) {
  io::Snapshot start = Simulation(scene(spheres, plane), linear(0.5, 0.5), undamped(dt)).snapshot();
  EXPECT_EQ(start.contacts.size(), 1U);
  start.contacts.shear_force[0] = Vec3(0.1, 0, 0);
  Simulation simulation(start, linear(0.5, 0.5), undamped(dt));
  simulation.step();
  return simulation.snapshot().contacts.shear_force[0].normalized();
}

TEST(Motion, ShearForcesTurnAboutTheNormalByTheMeanSpin) {
  const double dt = 1e-7, spin = 2e5;  // 0.02 rad per step
  Sphere low = free_sphere(), high = low;
  high.position.z() += 1.999 * R;
  for (const auto& [one, two] :
       {std::pair(1.0, 1.0), std::pair(1.0, 0.0), std::pair(0.0, -1.0), std::pair(1.0, -1.0)}) {
    low.spin.z() = one * spin, high.spin.z() = two * spin;
    const double angle = 0.5 * (one + two) * spin * dt;
    EXPECT_LT((turned_shear({low, high}, false, dt) - Vec3(std::cos(angle), std::sin(angle), 0)).norm(), 1e-4)
        << one << " and " << two;
  }
  Sphere on_plane = low;
  on_plane.position.z() = 0.999 * R;
  on_plane.spin.z() = spin;
  const double angle = 0.5 * spin * dt;  // the plane does not turn
  EXPECT_LT((turned_shear({on_plane}, true, dt) - Vec3(std::cos(angle), std::sin(angle), 0)).norm(), 1e-4);
}

// ---- Steps with several settings.

// Only strained axes slow down. Stresses are held at the full rate.
TEST(Servo, APaceIsThatOfTheStrainedAxesAlone) {
  const auto rates = [](double pace) {
    Simulation s(support::packed(support::sand(), 1e5, 60), support::sand(), {});
    Servo servo;
    const AxisGoal up{AxisGoal::Kind::stress, 1.1e5, 1}, strained{AxisGoal::Kind::strain, 0.1, 0.1};
    servo.drive({up, up, strained}, 3, s, pace);
    return Vec3(s.snapshot().cell.velocity_gradient.diagonal());
  };
  const Vec3 full = rates(1), slow = rates(0.01);
  EXPECT_EQ(slow.x(), full.x());
  EXPECT_EQ(slow.y(), full.y());
  EXPECT_LT(full.x(), 0);
  EXPECT_DOUBLE_EQ(full.z(), -0.1);
  EXPECT_DOUBLE_EQ(slow.z(), -0.001);
}

}  // namespace
}  // namespace soilweave::dem
