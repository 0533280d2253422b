// Both scales together: the bits of grains alone, in every element, on any number of threads, and after a stop.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "dem/run/run.h"
#include "fem/model/model.h"
#include "fem/run/record.h"
#include "support/assemblies.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::fem {
namespace {

constexpr double step = 0x1p-12;        // s
constexpr double grain_step = 0x1p-16;  // s

const io::Snapshot& disks() {
  static const io::Snapshot packing = support::packed(support::linear_sand(), 1e4, 40, 2);
  return packing;
}

Grains grains(bool fixed_step = true) {
  Grains g{support::linear_sand(), {}, 0};
  if (fixed_step) g.numerics.time_step = grain_step;
  return g;
}

ModelSetup strained(Index squares, const Mat2& gradient) {
  ModelSetup setup;
  setup.soil.mesh = rectangle(1, 1, squares, squares, Shape::triangle3);
  setup.soil.density = 1e9;  // so heavy that the step below is stable
  setup.soil.supports = {{"all", {}, {}, gradient}};
  setup.grains = grains();
  setup.packings = {disks()};
  setup.time_step = step;
  return setup;
}

TEST(Model, OneElementIsItsPackingLoadedAloneBitForBit) {
  const double rate = 0x1p-4;
  const int steps = 12;
  Model model(strained(1, (Mat2() << 0, 0, 0, -rate).finished()));
  ASSERT_EQ(model.substeps(), 16);
  for (int k = 0; k < steps; ++k) model.step();

  // run-dem holds its largest rate all the way, since the goal lies a hair beyond.
  dem::Scenario scenario;
  scenario.model = support::linear_sand();
  scenario.numerics = grains().numerics;
  scenario.tolerances = {0.9, 0.999};
  scenario.largest_station = 100000;
  const double strain = -16 * steps * std::log1p(-rate * grain_step) + 1e-10;
  Settings stage = Settings::parse(
      "[x]\nstrain = 0\nmax_rate = 1\n[y]\nstrain = " + std::to_string(0) + "\nmax_rate = " + std::to_string(rate),
      "test");
  stage.set(fmt::format("y.strain={:.17g}", strain));
  scenario.stages.emplace_back();
  scenario.stages[0].path = dem::read_path("free", stage);
  const dem::Outcome alone = dem::run(prepare(disks(), grains()), scenario, {});
  for (Index p = 0; p < 2; ++p) {
    io::Snapshot state = *model.points()[p]->packing();
    EXPECT_EQ(state.cell.velocity_gradient, alone.file.snapshots.back().cell.velocity_gradient);
    state.cell.velocity_gradient = alone.file.snapshots.back().cell.velocity_gradient;  // zeros have signs
    io::test::expect_same(state, alone.file.snapshots.back());
  }
}

TEST(Rve, FollowsGradientsThatDoNotCommuteInTheirOrder) {
  // Shear along x, then along y, gives F = (I + g e_y e_x)(I + g e_x e_y), in which only the lower right corner is 1 +
  // g^2. Both shears are nilpotent, so sixteenths of them add up exactly.
  const Grains g = grains();
  const io::Snapshot start = prepare(disks(), g);
  Rve rve(start, g, step, 16);
  const double shear = 0x1p-8;
  rve.advance((Mat2() << 0, shear, 0, 0).finished());
  rve.advance((Mat2() << 0, 0, shear, 0).finished());
  Mat3 expected = Mat3::Identity();
  expected.topLeftCorner<2, 2>() << 1, shear, shear, 1 + shear * shear;
  const io::CellRecord cell = rve.packing()->cell;
  EXPECT_LT((cell.deformation_gradient - expected).norm(), 1e-15);
  EXPECT_LT((cell.matrix - expected * start.cell.matrix).norm(), 1e-15 * start.cell.matrix.norm());
}

io::ContactsRecord normals_at(const std::vector<double>& degrees) {
  io::ContactsRecord contacts;
  for (const double d : degrees) {
    contacts.bodies.push_back({0, 1});
    contacts.normal.emplace_back(std::cos(d * support::degree), std::sin(d * support::degree), 0);
  }
  return contacts;
}

TEST(Rve, AnisotropyIsTwiceTheSecondHarmonicOfTheContactNormals) {
  // F_a = 2 |mean of exp(2 i theta)| does not depend on the sense of the normals.
  EXPECT_EQ(anisotropy({}), -1);
  EXPECT_NEAR(anisotropy(normals_at({20, 110})), 0, 1e-15);
  EXPECT_NEAR(anisotropy(normals_at({30, 30, 210})), 2, 1e-14);
  EXPECT_NEAR(anisotropy(normals_at({0, 60})), 1, 1e-14);
  EXPECT_NEAR(anisotropy(normals_at({15, 15, 105})), 2.0 / 3, 1e-14);
  // Even angles are chosen as often as the density 1 + F_a cos 2(theta - 25 deg) says; its integral gives the harmonic.
  std::vector<double> drawn;
  double owed = 0;
  for (int k = 0; k < 3600; ++k) {
    owed += 10 * (1 + 0.4 * std::cos(2 * (0.1 * k - 25) * support::degree));
    for (; owed >= 1; owed -= 1) drawn.push_back(0.1 * k);
  }
  EXPECT_NEAR(anisotropy(normals_at(drawn)), 0.4, 1e-3) << "one in 36,000 too many or too few";
}

TEST(Model, EqualStrainGivesEveryPointTheSameBits) {
  Model model(strained(3, (Mat2() << 0x1p-6, 0x1p-5, -0x1p-7, -0x1p-5).finished()));
  for (int k = 0; k < 10; ++k) model.step();
  const io::Snapshot first = *model.points()[0]->packing();
  for (Index p = 1; p < model.points().size(); ++p) {
    SCOPED_TRACE(p);
    io::test::expect_same(first, *model.points()[p]->packing());
  }
}

TEST(Model, ATurnedPackingTurnsItsStress) {
  // Disks that spin with the cell rotate with it as a whole. The straight steps of the cell, a hundred per milliradian,
  // widen it by 2e-6, which takes 1.7e-4 of the pressure; contacts turn by chords.
  const Grains g = grains(false);
  const double angle = 1e-3, dt = 1e-3;
  io::Snapshot start = prepare(disks(), g);
  for (Vec3& spin : start.grains.angular_velocity) spin = Vec3(0, 0, angle / dt);
  Rve rve(start, g, dt, 100);
  const Mat2 before = rve.stress();
  for (int k = 0; k < 200; ++k) rve.advance((Mat2() << 0, -angle, angle, 0).finished());
  const double c = std::cos(0.2), s = std::sin(0.2);
  const Mat2 whole = (Mat2() << c, -s, s, c).finished(), turned = whole * before * whole.transpose();
  EXPECT_LT((rve.stress() - turned).norm(), 3e-4 * before.norm());
  // Grains that were not quite at rest fluctuate about it.
  EXPECT_NEAR(rve.local().rotation, 0.2, 3e-4);
}

TEST(Rve, BeginsWithoutRotationWhateverItsPackingHasBeenThrough) {
  double rolled = 0;
  for (const Vec4& q : disks().grains.orientation) rolled += std::abs(q[3]);
  EXPECT_GT(rolled, 0.1) << "compaction has turned the disks";
  const Grains g = grains();
  EXPECT_EQ(Rve(prepare(disks(), g), g, step, 16).local().rotation, 0);
}

TEST(Rve, IsBoundedByTheStiffnessOfANetworkOfCentralForces) {
  const Grains g = grains();
  const Rve rve(prepare(disks(), g), g, step, 16);
  const Mat3 t = rve.tangent();
  const double stiffness =
      dem::Simulation(disks(), g.model, g.numerics).measures().axial_stiffness.head<2>().maxCoeff();
  EXPECT_NEAR(t(0, 0), stiffness, 1e-9 * stiffness);
  EXPECT_EQ(t(1, 1), t(0, 0));
  for (const double third : {t(0, 1), t(1, 0), t(2, 2)}) EXPECT_EQ(third, t(0, 0) / 3) << "Cauchy's relations";
}

TEST(Record, PointsHaveStressAndStrainCompressionPositiveAndRotationCounterClockwise) {
  // Every node follows one velocity gradient. The strains are its sum over the steps, the stress is Hooke's except for
  // the squared strain, 1e-5.
  const Mat2 gradient = (Mat2() << -0.02, 0.005, 0.013, 0.01).finished();
  const double dt = 0x1p-12, lame = 1e7 * 0.25 / (1.25 * 0.5), shear = 1e7 / 2.5;
  ModelSetup setup = strained(1, gradient);
  setup.packings.clear();
  setup.soil.density = 1600;
  setup.law = ContinuumLaw{1e7, 0.25, {}, 0, 0, Vec3::Zero()};
  setup.time_step = dt;
  Model model(setup);
  const int steps = 4;
  for (int k = 0; k < steps; ++k) model.step();
  io::MultiscaleFile file;
  record(model, {}, file);
  const auto group =
      std::find_if(file.groups.begin(), file.groups.end(), [](const auto& g) { return g.name == "points"; });
  ASSERT_NE(group, file.groups.end());
  const Mat2 sum = steps * dt * gradient, e = 0.5 * (sum + sum.transpose());
  const Mat2 stress = lame * e.trace() * Mat2::Identity() + 2 * shear * e;
  const double size = sum.norm();
  for (std::size_t row = 0; row < 2; ++row) {
    const auto value = [&](const char* name) { return group->table.at(name).values.at(row); };
    EXPECT_NEAR(value("strain_xx"), -e(0, 0), 1e-12 * size);
    EXPECT_NEAR(value("strain_yy"), -e(1, 1), 1e-12 * size);
    EXPECT_NEAR(value("strain_xy"), -e(0, 1), 1e-12 * size);
    EXPECT_NEAR(value("strain_volumetric"), -e.trace(), 1e-12 * size);
    EXPECT_NEAR(value("strain_shear"), std::hypot(e(0, 0) - e(1, 1), 2 * e(0, 1)), 1e-12 * size);
    EXPECT_NEAR(value("strain_rotation"), 0.5 * (sum(1, 0) - sum(0, 1)), 1e-12 * size);
    EXPECT_NEAR(value("stress_xx"), -stress(0, 0), 1e-4 * stress.norm());
    EXPECT_NEAR(value("stress_yy"), -stress(1, 1), 1e-4 * stress.norm());
    EXPECT_NEAR(value("stress_xy"), -stress(0, 1), 1e-4 * stress.norm());
    EXPECT_NEAR(value("mean_stress"), -0.5 * stress.trace(), 1e-4 * stress.norm());
    EXPECT_NEAR(value("deviatoric_stress"), std::hypot(0.5 * (stress(0, 0) - stress(1, 1)), stress(0, 1)),
                1e-4 * stress.norm());
  }
}

ModelSetup pulled(int threads) {
  ModelSetup setup;
  setup.soil.mesh = rectangle(0.4, 0.2, 2, 1, Shape::triangle3);
  setup.soil.damping = 0.2;
  setup.soil.supports = {{"left", 0.0, {}, {}}, {"right", 0.0, {}, {}}};
  setup.soil.tractions = {{"top", Vec2(0, -1e4)}};
  setup.grains = grains(false);
  setup.packings = {disks()};
  BarsSetup bars;
  bars.radius = 5e-3;
  bars.stiffness = 2e5;
  bars.areal_density = 3.5;
  bars.damping = 0.4;
  bars.touch = {1e9, 0.33, 0.35};
  bars.guides = {{{-1, -0.02}, {1, -0.02}, true}};
  bars.end = {0.02, 0};
  setup.bars = bars;
  setup.along = {"bottom"};
  setup.spacing = 0.04;
  setup.seat_pressure = 1e4;
  setup.safety = 0.6;
  setup.threads = threads;
  return setup;
}

void expect_same(const Model& a, const Model& b) {
  EXPECT_EQ(a.soil().positions(), b.soil().positions());
  EXPECT_EQ(a.soil().velocities(), b.soil().velocities());
  EXPECT_EQ(a.bars()->nodes(), b.bars()->nodes());
  for (Index p = 0; p < a.points().size(); ++p) {
    EXPECT_EQ(a.points()[p]->stress(), b.points()[p]->stress());
    io::test::expect_same(*a.points()[p]->packing(), *b.points()[p]->packing());
  }
  EXPECT_EQ(a.balance().external, b.balance().external);
  EXPECT_EQ(a.balance().stored, b.balance().stored);
}

TEST(Model, HasTheSameBitsOnAnyNumberOfThreadsAndAfterAStop) {
  Model one(pulled(1)), two(pulled(2)), three(pulled(3)), resumed(pulled(2));
  const int half = 20;
  for (int k = 0; k < half; ++k) one.step();
  Archive kept;
  one.archive(kept);
  Archive given(kept.numbers(), "memory");
  resumed.archive(given);
  for (int k = 0; k < half; ++k) one.step(), resumed.step();
  for (int k = 0; k < 2 * half; ++k) two.step(), three.step();
  expect_same(one, resumed);
  expect_same(one, two);
  expect_same(one, three);
}

TEST(Model, AccountsForAllWork) {
  Model model(pulled(1));
  for (int k = 0; k < 150; ++k) model.step();
  const Balance b = model.balance();
  EXPECT_GT(b.external, 0);
  // Leap-frog leaves an error of 2.5e-4; the smallest part, kinetic energy, is 7e-3.
  EXPECT_LT(std::abs(b.error()), 5e-4 * b.external);
  EXPECT_GT(b.kinetic, 5e-3 * b.external);
  EXPECT_NO_THROW(model.check_steps());
}

TEST(Model, RecordsTablesAndGivesAPointAsARun) {
  Model model(pulled(1));
  io::MultiscaleFile file;
  record(model, {3}, file);
  for (int k = 0; k < 3; ++k) model.step();
  record(model, {3}, file);
  const io::RunFile run = run_of_point(file, 3);
  EXPECT_EQ(run.snapshots.size(), 2U);
  EXPECT_EQ(run.series.rows(), 2U);
  io::test::expect_same(run.snapshots[1], *model.points()[3]->packing());
  io::test::expect_error<DataError>([&] { run_of_point(file, 2); }, "name it in record.points");
  io::test::expect_error<DataError>([&] { run_of_point(file, 4); }, "the soil has no point 4");
  const io::test::Folder folder;
  io::write_multiscale(folder / "run.h5", file, {});
  const io::MultiscaleFile read = io::read_multiscale(folder / "run.h5");
  ASSERT_EQ(read.groups.size(), file.groups.size());
  for (std::size_t g = 0; g < read.groups.size(); ++g)
    io::test::expect_same(read.groups[g].table, file.groups[g].table);
  io::test::expect_same(read.frames.at(1), file.frames.at(1));
}

TEST(Model, RefusesWhatCannotWork) {
  ModelSetup setup = pulled(1);
  setup.time_step = 1;
  io::test::expect_error<DataError>([&] { Model model(setup); }, "is over the stable one of");
  setup = pulled(1);
  setup.packings.push_back(disks());
  io::test::expect_error<DataError>([&] { Model model(setup); }, "2 packings are given for 4 points");
  setup = pulled(1);
  setup.packings = {support::packed(support::linear_sand(), 1e4, 60, 3)};
  io::test::expect_error<DataError>([&] { Model model(setup); }, "needs disks");
  setup = pulled(1);
  for (double& radius : setup.packings[0].grains.radius) radius *= 0.5;
  setup.packings[0].contacts = {};
  io::test::expect_error<DataError>([&] { Model model(setup); }, "packing 1 of 1 has no contacts");
}

TEST(Rve, AdvisesToLowerAStepThatMayHaveBeenGiven) {
  io::Snapshot broken = prepare(disks(), grains());
  broken.grains.velocity[0].x() = std::numeric_limits<double>::quiet_NaN();
  io::test::expect_error<PhysicsError>([&] { Rve(broken, grains(false), step, 16).advance(Mat2::Zero()); },
                                       "lower numerics.time_step where it is given, else numerics.time_step_safety");
}

TEST(Model, NamesTheElementWhoseGrainsAreCrushed) {
  ModelSetup setup = strained(1, (Mat2() << 0, 0, 0, -200).finished());
  setup.soil.density = 1e12;
  Model model(setup);
  io::test::expect_error<PhysicsError>(
      [&] {
        for (int k = 0; k < 100; ++k) model.step();
      },
      "element 0, point 0 at");
}

}  // namespace
}  // namespace soilweave::fem
