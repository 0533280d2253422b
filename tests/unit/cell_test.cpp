// Order and dimension: gradients and spins do not commute, and the thickness of a cell of disks has no effect.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/state/cell.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/measure/stress.h"
#include "dem/engine/simulation.h"
#include "support/assemblies.h"
#include "support/impact.h"

namespace soilweave::dem {
namespace {

// dF/dt = L F and dH/dt = L H: a later stretch acts on what the earlier shear has made, F = (1 + L2 dt)(1 + L1 dt).
TEST(Cell, ALaterGradientActsOnTheCellAsItIs) {
  io::CellRecord record;
  record.matrix = Vec3(2, 3, 4).asDiagonal();
  Cell cell(record, 3);
  Mat3 shear = Mat3::Zero(), stretch = Mat3::Zero();
  shear(0, 1) = 0.5;
  stretch(0, 0) = 1;
  cell.set_velocity_gradient(shear), cell.advance(0.5);
  cell.set_velocity_gradient(stretch), cell.advance(1);
  Mat3 expected = Mat3::Identity();
  expected(0, 0) = 2, expected(0, 1) = 2 * 0.25;  // the other order would leave 0.25
  EXPECT_EQ(cell.deformation_gradient(), expected);
  EXPECT_EQ(cell.matrix(), Mat3(expected * record.matrix));
  EXPECT_EQ(cell.volume(), 48);
}

// Along each axis the cell is as wide as its faces are apart: volume over the area of a face.
TEST(Cell, WidthsAreTheDistancesOfItsFaces) {
  io::CellRecord record;
  record.matrix << 2, 1, 0, 0, 3, 0, 0, 0, 4;  // columns: the cell vectors
  const Cell cell(record, 3);
  EXPECT_NEAR(cell.widths().x(), 24 / (4 * std::hypot(1, 3)), 1e-15);
  EXPECT_NEAR(cell.widths().y(), 24 / (4 * 2.0), 1e-15);
  EXPECT_NEAR(cell.widths().z(), 4, 1e-15);
}

// A grain turned by a about x and then by b about y, with fixed axes, has q = q_y q_x.
TEST(Simulation, TurnsAGrainAboutXAndThenAboutY) {
  const double a = 1, b = 0.7, dt = 1e-4;
  const int steps = 2000;
  io::Snapshot state =
      test::scene({{0.01, 2650, Vec3(0.1, 0.1, 0.1), Vec3::Zero(), Vec3(a / (steps * dt), 0, 0)}}, false);
  const auto turned = [&](const io::Snapshot& from) {
    Simulation s(from, support::sand(), test::undamped(dt));
    for (int k = 0; k < steps; ++k) s.step();
    return s.snapshot();
  };
  state = turned(state);
  state.grains.angular_velocity[0] = Vec3(0, b / (steps * dt), 0);
  const Vec4 q = turned(state).grains.orientation[0];
  const double ca = std::cos(a / 2), sa = std::sin(a / 2), cb = std::cos(b / 2), sb = std::sin(b / 2);
  // j i = -k. The angle of a step is short by the cube of its half over three: 5e-8 over all.
  EXPECT_LT((q - Vec4(cb * ca, cb * sa, sb * ca, -sb * sa)).norm(), 1e-7) << q.transpose();
}

// Disks are per metre. The given thickness of their cell changes no area, stress or void ratio, and is kept.
TEST(Disks, NothingDependsOnTheThicknessOfTheirCell) {
  io::Snapshot thin = support::packed(support::linear_sand(), 1e3, 60, 2), thick = thin;
  thin.cell.matrix(2, 2) = 1, thick.cell.matrix(2, 2) = 3;
  Simulation one(thin, support::linear_sand(), {}), three(thick, support::linear_sand(), {});
  Mat3 gradient = Mat3::Zero();
  gradient(0, 0) = 0.1, gradient(1, 1) = -0.2;
  for (Simulation* s : {&one, &three}) {
    s->set_velocity_gradient(gradient);
    for (int k = 0; k < 50; ++k) s->step();
  }
  EXPECT_EQ(three.volume(), one.volume());
  EXPECT_EQ(three.void_ratio(), one.void_ratio());
  EXPECT_EQ(three.measures().stress, one.measures().stress);
  EXPECT_EQ(three.measures().axial_stiffness, one.measures().axial_stiffness);
  EXPECT_EQ(three.energies()["boundary_work"], one.energies()["boundary_work"]);
  EXPECT_EQ(three.snapshot().cell.matrix(2, 2), 3);
  EXPECT_EQ(analysis::cell_stress(thick), analysis::cell_stress(thin));
  EXPECT_NEAR(one.measures().stress(1, 1), analysis::cell_stress(one.snapshot())(1, 1),
              1e-9 * one.measures().stress(1, 1));
}

}  // namespace
}  // namespace soilweave::dem
