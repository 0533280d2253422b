// Both scales together: the same bits as grains alone, in every element, on any number of threads, and after a stop.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/error.h"
#include "dem/run.h"
#include "fem/model.h"
#include "fem/record.h"
#include "support/assemblies.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::fem {
namespace {

constexpr double step = 0x1p-12;        // s
constexpr double grain_step = 0x1p-16;  // s

const io::Snapshot& disks() {
  static const io::Snapshot packing = testing::packed(testing::linear_sand(), 1e4, 40, 2);
  return packing;
}

Grains grains(bool fixed_step = true) {
  Grains g{testing::linear_sand(), {}, 0};
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

TEST(Model, one_element_is_its_packing_loaded_alone_bit_for_bit) {
  const double rate = 0x1p-4;
  const int steps = 12;
  Model model(strained(1, (Mat2() << 0, 0, 0, -rate).finished()));
  ASSERT_EQ(model.substeps(), 16);
  for (int k = 0; k < steps; ++k) model.step();

  // run-dem holds its largest rate all the way, since the goal lies a hair beyond.
  dem::Scenario scenario;
  scenario.model = testing::linear_sand();
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

TEST(Model, equal_strain_gives_every_point_the_same_bits) {
  Model model(strained(3, (Mat2() << 0x1p-6, 0x1p-5, -0x1p-7, -0x1p-5).finished()));
  for (int k = 0; k < 10; ++k) model.step();
  const io::Snapshot first = *model.points()[0]->packing();
  for (Index p = 1; p < model.points().size(); ++p) {
    SCOPED_TRACE(p);
    io::test::expect_same(first, *model.points()[p]->packing());
  }
}

TEST(Model, a_turned_packing_turns_its_stress) {
  const Grains g = grains(false);
  Rve rve(prepare(disks(), g), g, 1e-3, 100);
  const Mat2 before = rve.stress();
  const double angle = 1e-3;
  const Mat2 turn = (Mat2() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)).finished();
  Mat2 whole = Mat2::Identity();
  for (int k = 0; k < 200; ++k) rve.advance(turn - Mat2::Identity()), whole = turn * whole;
  const Mat2 turned = whole * before * whole.transpose();
  // Grains spin up by friction alone, and the cell takes small straight steps: a few per cent.
  EXPECT_LT((rve.stress() - turned).norm(), 0.1 * before.norm());
  EXPECT_NEAR(rve.local().rotation, 0.2, 0.05);
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

TEST(Model, has_the_same_bits_on_any_number_of_threads_and_after_a_stop) {
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

TEST(Model, accounts_for_all_work) {
  Model model(pulled(1));
  for (int k = 0; k < 150; ++k) model.step();
  const Balance b = model.balance();
  EXPECT_GT(b.external, 0);
  EXPECT_LT(std::abs(b.error()), 0.01 * b.external);
  EXPECT_NO_THROW(model.check_steps());
}

TEST(Model, records_tables_and_gives_a_point_as_a_run) {
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
  const io::test::Folder folder;
  io::write_multiscale(folder / "run.h5", file, {});
  const io::MultiscaleFile read = io::read_multiscale(folder / "run.h5");
  ASSERT_EQ(read.groups.size(), file.groups.size());
  for (std::size_t g = 0; g < read.groups.size(); ++g)
    io::test::expect_same(read.groups[g].table, file.groups[g].table);
  io::test::expect_same(read.frames.at(1), file.frames.at(1));
}

TEST(Model, refuses_what_cannot_work) {
  ModelSetup setup = pulled(1);
  setup.time_step = 1;
  io::test::expect_error<DataError>([&] { Model model(setup); }, "is over the stable one of");
  setup = pulled(1);
  setup.packings.push_back(disks());
  io::test::expect_error<DataError>([&] { Model model(setup); }, "2 packings are given for 4 points");
  setup = pulled(1);
  setup.packings = {testing::packed(testing::linear_sand(), 1e4, 60, 3)};
  io::test::expect_error<DataError>([&] { Model model(setup); }, "needs disks");
}

TEST(Model, names_the_element_whose_grains_are_crushed) {
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
