// Yarns in a periodic cell: they contribute to its stress, to the servo's stiffness and to the work at its faces. A
// fabric touches its own image, and no yarn passes through a face.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/measure/stress.h"
#include "core/archive.h"
#include "core/error.h"
#include "dem/run/run.h"
#include "packing/expand/plan.h"
#include "support/assemblies.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::dem {
namespace {

using io::test::expect_error;

const std::string node =
    "law = \"hertz-mindlin\"\nyoung_modulus = \"8 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 21\n";
const std::string materials = "[contact]\n" + node + "[[material]]\n" + node.substr(node.find('\n') + 1);
const std::string pe = "[[geotextile]]\nyarn_strain = [0.02, 0.06, 0.17035]\nyarn_tension = [8.4, 20.6, 47.5]\n";

// Returns flat sheets of n times m yarns, 5 mm long, in the middle of a periodic cell.
io::Snapshot sheets(const std::vector<double>& heights, const Vec3& cell, int n = 10, int m = 10,
                    const std::string& density = "444e3") {
  std::string text = "[container]\nshape = \"none\"\n";
  for (const double height : heights)
    text += "[[sheet]]\ncells = [" + std::to_string(n) + ", " + std::to_string(m) +
            ", 1]\nheight = " + std::to_string(height) + "\nnode_density = " + density + "\n";
  io::Snapshot state = packing::assemble({}, packing::read_plan(text + materials, "plan", {}));
  state.cell.matrix = cell.asDiagonal();
  state.cell.periodic = {true, true, true};
  for (Vec3& x : state.grains.position) x += 0.5 * cell;
  return state;
}

Scenario scenario(const std::string& stages) { return read_scenario(materials + pe + stages, "test", {}); }

// Returns -sum T l n (x) n / V of the record.
Mat3 expected_stress(const io::Snapshot& s) {
  Mat3 sum = Mat3::Zero();
  for (std::size_t k = 0; k < s.yarns.size(); ++k) {
    const Vec3 d = s.grains.position[static_cast<std::size_t>(s.yarns.nodes[k][1])] -
                   s.grains.position[static_cast<std::size_t>(s.yarns.nodes[k][0])];
    sum -= s.yarns.tension[k] * d.norm() * d.normalized() * d.normalized().transpose();
  }
  return sum / s.cell.matrix.determinant();
}

const Vec3 cell_of_sheet(0.06, 0.06, 0.02);
const double stretch = std::exp(0.02), stretched_volume = cell_of_sheet.prod() * std::exp(0.018);

// Returns a run of a sheet whose nodes are held and move with the cell, stretched by 2 % along x and slack along y.
io::RunFile stretched(double rate) {
  const Scenario plan = scenario(
      "[equilibrium]\nunbalanced_force = 0.99\n[[clamp]]\nname = \"all\"\nlow = [-1, -1, -1]\nhigh = [1, 1, 1]\n"
      "[[stage]]\npath = \"free\"\n[stage.x]\nstrain = -0.02\nmax_rate = " +
      std::to_string(rate) + "\n[stage.y]\nstrain = 0.002\nmax_rate = " + std::to_string(rate / 10) + "\n");
  return run(prepare(sheets({0}, cell_of_sheet), plan), plan, {}).file;
}
double last(const io::RunFile& file, const char* name) { return file.series.at(name).values.back(); }

TEST(YarnsInACell, AreItsStress) {
  const io::RunFile file = stretched(1);
  // 11 rows of 10 yarns have the strain of the cell, on the second piece of their curve.
  const double length = 0.005 * stretch;
  const double tension = 8.4 + (stretch - 1.02) * (20.6 - 8.4) / 0.04;
  const double stress = -110 * tension * length / stretched_volume;
  EXPECT_NEAR(stress, -64765.16, 0.01);
  EXPECT_NEAR(last(file, "stress_xx"), stress, 1e-10 * std::abs(stress));
  for (const char* other : {"stress_yy", "stress_zz", "stress_xy"}) EXPECT_NEAR(last(file, other), 0, 1e-10) << other;
  EXPECT_NEAR(analysis::cell_stress(file.snapshots.back())(0, 0), stress, 1e-10 * std::abs(stress));
  EXPECT_EQ(analysis::contact_stress(file.snapshots.back()), Mat3(Mat3::Zero()));
  io::Snapshot open = file.snapshots.back();
  open.cell.periodic = {false, false, false};
  EXPECT_EQ(analysis::cell_stress(open), Mat3(Mat3::Zero())) << "an open cell has no faces that feel yarns";
}

TEST(YarnsInACell, TakeTheWorkOfItsFaces) {
  // The work of a step has an error of first order in its strain, for yarns as for contacts.
  std::vector<double> errors;
  for (const double rate : {1.0, 0.1}) {
    const io::RunFile file = stretched(rate);
    const double held = last(file, "yarn_elastic_energy") + last(file, "yarn_dissipation");
    EXPECT_NEAR(held, 110 * 0.005 * 0.5 * 0.02 * 8.4, 0.03 * held) << "the area under the curve up to 0.0202";
    errors.push_back(std::abs(last(file, "energy_error")) / last(file, "boundary_work"));
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_NEAR(errors[1] / errors[0], 0.1, 0.02);
}

TEST(YarnsInACell, AreItsStressWhileNodesMoveAndTheCellShears) {
  const Scenario plan = scenario("[numerics]\ndamping = 0\n[[stage]]\npath = \"isotropic\"\npressure = 1e5\n");
  Simulation simulation(prepare(sheets({0}, cell_of_sheet, 10, 10, "2650e3"), plan), plan.model, plan.numerics);
  Mat3 gradient = Mat3::Zero();
  gradient(0, 0) = 3, gradient(1, 1) = 1, gradient(0, 1) = 0.5, gradient(2, 0) = 1;
  simulation.set_velocity_gradient(gradient);
  for (int k = 0; k < 12; ++k) simulation.step();
  const Mat3 expected = expected_stress(simulation.snapshot());
  EXPECT_LT(expected(0, 0), -1e4);
  EXPECT_GT(std::abs(expected(0, 2)), 10);
  EXPECT_LT((simulation.measures().stress - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LT((analysis::cell_stress(simulation.snapshot()) - expected).norm(), 1e-12 * expected.norm());
}

TEST(YarnsInACell, AreAsStiffForItsServoAsTheyArePulled) {
  const io::Snapshot end = stretched(1).snapshots.back();
  const Scenario plan = scenario("[[stage]]\npath = \"isotropic\"\npressure = 1e5\n");
  const Simulation simulation(end, plan.model, plan.numerics);
  const Vec3 stiffness = simulation.measures().axial_stiffness;
  // d stress/d strain comes from 110 yarns on their first slope, 420 N; the slack ones across add none.
  const double length = 0.005 * stretch;
  EXPECT_NEAR(stiffness.x(), 110 * 420 / 0.005 * length * length / stretched_volume, 1e-9 * stiffness.x());
  EXPECT_EQ(stiffness.y(), 0);
  EXPECT_EQ(stiffness.z(), 0);
}

// Three layers of one fabric, 4 mm apart, nodes of 2.5 mm: they lie in each other without touching. The outer two are
// 4.95 mm apart through the face.
TEST(YarnsInACell, AFabricTouchesItsImage) {
  io::Snapshot state = sheets({-0.004, 0, 0.004}, Vec3(0.06, 0.06, 0.01295), 3, 3);
  state.yarns.fabric.assign(state.yarns.size(), 0);
  const Scenario plan = scenario("[[stage]]\npath = \"isotropic\"\npressure = 1e5\n");
  const Simulation simulation(prepare(state, plan), plan.model, plan.numerics);
  const io::ContactsRecord contacts = simulation.snapshot().contacts;
  ASSERT_EQ(contacts.size(), 16U) << "every node of the lowest layer touches one of the image of the highest";
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    EXPECT_EQ(contacts.image[c], Vec3i(0, 0, -1));
    EXPECT_EQ(contacts.bodies[c][1] - contacts.bodies[c][0], 32);
    EXPECT_GT(contacts.normal_force[c], 0);
  }
  EXPECT_GT(simulation.measures().stress(2, 2), 0);
}

TEST(YarnsInACell, PassThroughNoFace) {
  const Scenario plan = scenario("[[stage]]\npath = \"isotropic\"\npressure = 1e5\n");
  const io::Snapshot across = sheets({0}, cell_of_sheet);
  io::Snapshot moved = across, wrapped = across;
  for (Vec3& x : moved.grains.position) x.x() += 0.02;
  EXPECT_NO_THROW(prepare(moved, plan)) << "a fabric may lie across a face";
  wrapped = moved;
  for (Vec3& x : wrapped.grains.position) x.x() -= 0.06 * std::floor(x.x() / 0.06);
  expect_error<DataError>([&] { prepare(wrapped, plan); }, "passes through the periodic face along x");
  expect_error<DataError>([&] { Simulation(wrapped, plan.model, plan.numerics); }, "yarns have no images");
  io::Snapshot torn = wrapped, open = wrapped;
  torn.yarns.broken.assign(torn.yarns.size(), 1);
  EXPECT_NO_THROW(prepare(torn, plan));
  open.cell.periodic = {false, true, true};
  EXPECT_NO_THROW(Simulation(open, plan.model, plan.numerics));
}

}  // namespace
}  // namespace soilweave::dem
