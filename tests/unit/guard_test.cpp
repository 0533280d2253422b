// Broken physics is noticed and named, and sound physics is not taken for broken.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "dem/engine/simulation.h"
#include "support/assemblies.h"
#include "support/same_state.h"

namespace soilweave::dem {
namespace {

// Returns two grains of 1 mm in a wide cell, apart along x.
io::Snapshot two_grains() {
  io::Snapshot s;
  s.cell.matrix = 0.02 * Mat3::Identity();
  io::GrainsRecord& g = s.grains;
  for (const double x : {0.005, 0.0085}) {
    g.body_id.push_back(static_cast<std::int64_t>(g.position.size()));
    g.position.emplace_back(x, 0.01, 0.01);
    g.orientation.emplace_back(1, 0, 0, 0);
    g.velocity.emplace_back(Vec3::Zero());
    g.angular_velocity.emplace_back(Vec3::Zero());
    g.radius.push_back(1e-3);
    g.mass.push_back(1e-5);
    g.material_id.push_back(0);
    g.copy_id.push_back(0);
  }
  return s;
}

Numerics fixed(double step) {
  Numerics n;
  n.time_step = step;
  return n;
}

void run(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

TEST(Guard, NamesTheGrainThatIsNoNumber) {
  io::Snapshot state = two_grains();
  state.grains.velocity[1].y() = std::numeric_limits<double>::quiet_NaN();
  Simulation s(state, support::sand(), {});
  io::test::expect_error<PhysicsError>([&] { run(s, 1); }, "step 1: grain 1 has a position that is not a number");
  state = two_grains();
  state.grains.angular_velocity[0].z() = std::numeric_limits<double>::infinity();
  Simulation spinning(state, support::sand(), {});
  io::test::expect_error<PhysicsError>([&] { run(spinning, 1); }, "step 1: grain 0 has a spin that is not a number");
}

TEST(Guard, StopsAtAnOverlapBeyondItsLimit) {
  io::Snapshot state = two_grains();
  state.grains.velocity[1].x() = -100;
  Simulation s(state, support::sand(), fixed(1.2e-5));
  io::test::expect_error<PhysicsError>([&] { run(s, 10); }, "grains 0 and 1 overlap by 0.0009 m, 90 % of the radius");
  Numerics deep = fixed(1.2e-5);
  deep.limits.overlap = 0.95;
  Simulation soft(state, support::sand(), deep);
  EXPECT_NO_THROW(run(soft, 2));
}

TEST(Guard, StopsWhereAGrainSpansHalfTheCell) {
  Simulation s(two_grains(), support::sand(), fixed(1e-3));
  Mat3 gradient = Mat3::Zero();
  gradient(2, 2) = -10;
  s.set_velocity_gradient(gradient);
  // A strain of -1.6 shortens 20 mm to 4 mm, twice the diameter of a grain.
  io::test::expect_error<PhysicsError>([&] { run(s, 400); },
                                       "wide along axis z, and the largest grain is 0.002 m across");
  EXPECT_NEAR(s.cell_matrix()(2, 2), 0.004, 0.0005);
}

TEST(Guard, StopsAGrainThatEscapesBetweenPlanes) {
  io::Snapshot state = two_grains();
  state.cell.periodic = {false, true, true};
  state.planes.point = {Vec3::Zero()};
  state.planes.normal = {Vec3::UnitX()};
  state.planes.velocity = {Vec3::Zero()};
  state.planes.material_id = {0};
  state.grains.velocity[1].x() = 1;
  Simulation s(state, support::sand(), fixed(1e-5));
  io::test::expect_error<PhysicsError>([&] { run(s, 10'000); }, "grain 1 has gone to x = ");
  // It is twice the extent away, 8.5 mm from the plane and a grain, and at most one check later.
  EXPECT_NEAR(s.time(), 2 * 10.5e-3, 256 * 1e-5);
  state.planes = {};
  Simulation free(state, support::sand(), fixed(1e-5));
  EXPECT_NO_THROW(run(free, 3000));
}

}  // namespace
}  // namespace soilweave::dem
