// Yarns: the law of one yarn, and a strip of yarns between clamps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/error.h"
#include "dem/run/geotextile.h"
#include "dem/run/run.h"
#include "support/strip.h"

namespace soilweave::dem {
namespace {

using support::move;
using support::pe_points;
using support::pulled;
using support::strip;

const WireCurve pe{"PE", {0.02, 0.06, 0.17035}, {8.4, 20.6, 47.5}, 420};

TEST(Wire, FollowsItsCurveOnFirstLoading) {
  WireHistory history;
  EXPECT_DOUBLE_EQ(pull(pe, 0.01, history), 4.2);
  EXPECT_DOUBLE_EQ(pull(pe, 0.04, history), 14.5);
  EXPECT_DOUBLE_EQ(pull(pe, 0.17035, history), 47.5);
  EXPECT_FALSE(history.broken);
}

TEST(Wire, UnloadsAlongTheFirstSlopeFromThePlasticStrain) {
  WireHistory history;
  pull(pe, 0.06, history);
  const double plastic = 0.06 - 20.6 / 420;
  EXPECT_NEAR(pull(pe, 0.05, history), 420 * (0.05 - plastic), 1e-12);
  EXPECT_EQ(pull(pe, 0.9 * plastic, history), 0) << "below the plastic strain it is slack";
  EXPECT_EQ(pull(pe, -0.5, history), 0) << "compression carries nothing";
  EXPECT_NEAR(pull(pe, 0.055, history), 420 * (0.055 - plastic), 1e-12) << "reloading takes the same line";
  EXPECT_NEAR(pull(pe, 0.10, history), 20.6 + 0.04 * (47.5 - 20.6) / 0.11035, 1e-12) << "and then the curve";
}

TEST(Wire, BreaksBeyondItsLastPointForGood) {
  WireHistory history;
  EXPECT_EQ(pull(pe, 0.17036, history), 0);
  EXPECT_TRUE(history.broken);
  EXPECT_EQ(pull(pe, 0.05, history), 0);
}

TEST(Strip, EnergyOfYieldingIsAccountedFor) {
  const io::Snapshot start = strip(4);
  const Scenario plan = pulled(pe_points, move(2.4e-3, 4), 0.01);
  const io::RunFile run = dem::run(prepare(start, plan), plan, {}).file;
  const auto last = [&](const char* name) { return run.series.at(name).values.back(); };
  EXPECT_LT(std::abs(last("energy_error")), 1e-6 * last("boundary_work"));
  // The expected work of 8 yarns of 5 mm strained to 0.12 is the area under the curve; a slow pull leaves little to
  // damping.
  const double at_end = 20.6 + 0.06 * (47.5 - 20.6) / 0.11035;
  const double work = 8 * 0.005 * (0.5 * 0.02 * 8.4 + 0.5 * 0.04 * (8.4 + 20.6) + 0.5 * 0.06 * (20.6 + at_end));
  EXPECT_NEAR(last("yarn_elastic_energy") + last("yarn_dissipation"), work, 2e-3 * work);
}

// In a torn bag two nodes came to lie in exactly one place.
TEST(Strip, SlackYarnsWhoseEndsMeetPullAtNothing) {
  const Scenario plan = pulled(pe_points, move(1e-3, 1), 0.0025);
  io::Snapshot start = prepare(strip(1), plan);
  for (Vec3& x : start.grains.position) x.y() = 0;
  Simulation simulation(start, plan.model, plan.numerics);
  for (int k = 0; k < 20; ++k) simulation.step();
  EXPECT_EQ(simulation.yarns().tension, 0);
  EXPECT_EQ(simulation.snapshot().grains.position, start.grains.position);
}

TEST(Strip, ANodeIsHeldByOneClampAlone) {
  const Scenario plan = pulled(pe_points, move(1e-3, 1), 0);
  try {
    prepare(strip(2), plan);
    ADD_FAILURE() << "both clamps hold the nodes in the middle";
  } catch (const DataError& e) {
    EXPECT_NE(std::string(e.what()).find("clamps left and right both hold node"), std::string::npos) << e.what();
  }
}

// Without damping the strip swings for ever; here it swings on the way and comes to rest when the clamp stops.
TEST(Strip, ComesToRestWhereOnlyTheWaitIsDamped) {
  std::string stage = move(2.4e-3, 4);
  stage.insert(stage.find("parts"), "damping = 0\nrest_damping = 0.8\n");
  const Scenario plan = pulled(pe_points, stage, 0.01);
  const io::RunFile run = dem::run(prepare(strip(4), plan), plan, {}).file;
  EXPECT_LE(run.series.at("unbalanced_force").values.back(), 1e-9);
  EXPECT_GT(run.series.at("damping_dissipation").values.back(), 0);
}

TEST(Geotextile, RefusesCurvesThatTurnBack) {
  const std::string stage = move(1e-3, 1);
  EXPECT_THROW(pulled("yarn_strain = [0.02, 0.01]\nyarn_tension = [1, 2]\n", stage, 0.01), DataError);
  EXPECT_THROW(pulled("yarn_strain = [0.02]\nyarn_tension = [1, 2]\n", stage, 0.01), DataError);
  // The curve stiffens beyond its first slope, so unloading along that slope would end in compression.
  EXPECT_THROW(pulled("yarn_strain = [0.02, 0.04]\nyarn_tension = [1, 9]\n", stage, 0.01), DataError);
  EXPECT_THROW(pulled("curve = \"PX\"\n", stage, 0.01), DataError);
  try {
    pulled("yarn_strain = [0.02, 0.01]\nyarn_tension = [1, 2]\n", stage, 0.01);
  } catch (const DataError& e) {
    EXPECT_NE(std::string(e.what()).find("growing strain"), std::string::npos) << e.what();
  }
}

TEST(Geotextile, MultiplesOfKnownOnes) {
  std::vector<io::Source> sources;
  Settings one = Settings::parse("curve = \"PP\"\n", "a"), three = Settings::parse("curve = \"3PP\"\n", "b");
  const NamedFiles files{"test", {}};
  const WireCurve a = read_geotextile(one, "geotextile.0", files, sources);
  const WireCurve b = read_geotextile(three, "geotextile.0", files, sources);
  ASSERT_EQ(a.tension.size(), b.tension.size());
  for (std::size_t k = 0; k < a.tension.size(); ++k) EXPECT_DOUBLE_EQ(3 * a.tension[k], b.tension[k]);
  EXPECT_EQ(sources.size(), 2U) << "what was read is named for the history";
}

// Layers lie side by side. At equal strain a multiple bears so many times the force, in loading and unloading, and is
// slack below the same plastic strain.
TEST(Geotextile, AMultipleUnloadsAsManyTimesAsSteeply) {
  std::vector<io::Source> sources;
  const auto read = [&](const std::string& keys) {
    Settings table = Settings::parse(keys, "test");
    return read_geotextile(table, "geotextile.0", NamedFiles{"test", {}}, sources);
  };
  const auto expect_times = [](double times, const WireCurve& many, const WireCurve& one) {
    EXPECT_DOUBLE_EQ(many.unloading, times * one.unloading);
    EXPECT_EQ(many.strain, one.strain);
    WireHistory of_many, of_one;
    for (const double strain : {0.02, 0.1, 0.09, 0.06, 0.05, 0.12})
      EXPECT_NEAR(pull(many, strain, of_many), times * pull(one, strain, of_one), 1e-12 * times * one.tension.back())
          << times << " at " << strain;
  };
  const WireCurve pp = read("curve = \"PP\"\n");
  EXPECT_DOUBLE_EQ(pp.unloading, pp.tension[0] / pp.strain[0]);
  expect_times(0.5, read("curve = \"0.5PP\"\n"), pp);
  expect_times(2, read("curve = \"2PP\"\n"), pp);
  expect_times(6, read("curve = \"2PP\"\nmultiple = 3\n"), pp);
  const std::string steeper = pe_points + "unloading_slope = 600\n";
  EXPECT_EQ(read(steeper).unloading, 600);
  expect_times(2.5, read(steeper + "multiple = 2.5\n"), read(steeper));
}

}  // namespace
}  // namespace soilweave::dem
