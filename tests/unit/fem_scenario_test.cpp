// Scenarios of two scales: loads that act, supports that agree, and runs that end at their duration.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "fem/run/run.h"
#include "fem/run/scenario.h"
#include "support/same_state.h"

namespace soilweave::fem {
namespace {

using io::test::expect_error;

const std::string block =
    "[mesh]\nwidth = 1\nheight = 1\ncolumns = 2\nrows = 2\n"
    "[soil]\nmaterial = \"elastic\"\ndensity = 2000\nyoung_modulus = 1e7\npoisson_ratio = 0.25\ndamping = 100\n"
    "[time]\nduration = 0.2\noutput_interval = 0.1\n";
const std::string footing = "[[support]]\non = \"bottom\"\nx = 0\ny = 0\n";
const std::string load = "[[traction]]\non = \"top\"\ny = -1000\n";

Scenario scenario(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return read_scenario(block + text, "test.toml", overrides, std::nullopt);
}

void refused(const std::string& text, const std::string& words) {
  expect_error<DataError>([&] { scenario(text); }, words);
}

std::vector<std::string> doubts(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> keys;
  for (const Doubt& doubt : scenario(text, overrides).doubts) keys.push_back(doubt.key);
  return keys;
}

using Keys = std::vector<std::string>;

TEST(Scenario, RefusesTractionsThatCanLoadNothing) {
  EXPECT_TRUE(scenario(footing + load).doubts.empty());
  refused(
      footing + "[[traction]]\non = \"bottom-corners\"\ny = -1000\n",
      "traction.0.on: boundary \"bottom-corners\" has points alone and no length: name one with edges: bottom, left");
  refused(footing + "[[traction]]\non = \"nothing\"\ny = -1000\n",
          "traction.0.on: the mesh has no boundary \"nothing\"; known: bottom, left, right, top");
  refused(footing + "[[traction]]\non = \"all\"\ny = -1000\n", "test.toml:20: traction.0.on: the mesh has no boundary");
  refused(footing + "[[traction]]\non = \"top\"\n", "loads nothing: give x or y");
}

TEST(Scenario, DoubtsLoadsThatSupportsCarryAndSoilThatNothingLoads) {
  EXPECT_EQ(doubts(footing + "[[traction]]\non = \"bottom\"\ny = -1000\n"), Keys{"traction_carried"});
  EXPECT_EQ(doubts("[[support]]\non = \"bottom\"\nx = 0\n" + load + "[[traction]]\non = \"bottom\"\ny = 1000\n"),
            Keys{})
      << "the bottom is free along y";
  EXPECT_EQ(doubts(footing), Keys{"soil_unloaded"});
  EXPECT_EQ(doubts(footing + load, {"traction.0.y=0"}), Keys{"soil_unloaded"});
  EXPECT_EQ(doubts(footing, {"soil.initial_stress=[1,1,1]"}), Keys{});
  EXPECT_EQ(doubts(footing + "[[support]]\non = \"top\"\ny = -0.1\n"), Keys{});
}

TEST(Scenario, DoubtsSoilThatItsTractionsMoveAsAWhole) {
  EXPECT_EQ(doubts(load), Keys{"soil_free"});
  EXPECT_EQ(scenario(load).doubts[0].sentence,
            "no support holds the soil against its tractions, 0 N/m along x and -1000 N/m along y in all: they move or "
            "turn it "
            "as a whole; hold it by a [[support]]");
  EXPECT_EQ(doubts("[[support]]\non = \"left\"\nx = 0\n" + load), Keys{"soil_free"}) << "free along y";
  EXPECT_EQ(doubts("[[support]]\non = \"bottom\"\ny = 0\n" + load), Keys{}) << "free along x, where nothing pushes";
  EXPECT_EQ(doubts(load + "[[traction]]\non = \"bottom\"\ny = 1000\n"), Keys{}) << "balanced";
  EXPECT_EQ(doubts("[[traction]]\non = \"left\"\ny = -1000\n[[traction]]\non = \"right\"\ny = 1000\n"),
            Keys{"soil_free"})
      << "balanced, but for the moment";
  // A piece of the mesh may be free beside one that is held.
  Mesh two = rectangle(1, 1, 1, 1, Shape::triangle3), other = two;
  two.boundaries["roof"] = two.boundaries["top"];
  for (auto& [first, second] : two.boundaries["roof"].ends) first += 4, second += 4;
  two.boundaries["roof"].nodes = {6, 7};
  for (const Vec2& x : other.nodes) two.nodes.push_back(x + Vec2(2, 0));
  for (auto e : other.elements) two.elements.push_back({e[0] + 4, e[1] + 4, e[2] + 4});
  const std::string pieces = block.substr(block.find("[soil]")) + footing + load + "[mesh]\npieces = 2\n";
  EXPECT_TRUE(read_scenario(pieces, "test.toml", {}, two).doubts.empty());
  const std::vector<Doubt> free = read_scenario(pieces, "test.toml", {"traction.0.on=\"roof\""}, two).doubts;
  ASSERT_EQ(free.size(), 1U);
  EXPECT_NE(free[0].sentence.find("the soil around (2.5, 0.5) m"), std::string::npos) << free[0].sentence;
}

TEST(Scenario, RefusesSupportsThatContradictEachOtherByTheLineOfTheLater) {
  refused(footing + load + "[[support]]\non = \"right\"\nx = 0.1\n",
          "test.toml:22: support.1: the supports on \"bottom\"");
  EXPECT_NO_THROW(scenario(footing + load + "[[support]]\non = \"right\"\nx = 0\n"));
}

TEST(Scenario, RefusesKeysThatWouldHaveNoEffectOrAddUp) {
  refused(footing + load + "[[support]]\non = \"top\"\nx = 0\ngradient = [0.1, 0, 0, 0]\n",
          "support.1.gradient: is given beside x or y");
  EXPECT_NO_THROW(scenario(footing + load, {"time.step=1e-6"}));
  io::test::expect_error<DataError>(
      [] {
        scenario(footing + load, {"time.step=1e-6", "time.safety=0.4"});
      },
      "time.safety: has no effect beside step");
}

TEST(Scenario, CountsNoOutputsOfATimeThatIsRefused) {
  try {
    scenario(footing + load, {"time.duration=0"});
    ADD_FAILURE() << "taken";
  } catch (const DataError& error) {
    EXPECT_EQ(std::string(error.what()).find("outputs"), std::string::npos) << error.what();
  }
  io::test::expect_error<DataError>([] { scenario(footing + load, {"time.duration=1e8"}); }, "makes ");
}

const std::vector<std::string> sand = {"soil.material=\"mohr-coulomb\"", "soil.friction_angle=30"};

std::vector<std::string> with(std::vector<std::string> overrides, const std::vector<std::string>& more) {
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

TEST(Scenario, DoubtsFrictionAnglesInRadians) {
  EXPECT_EQ(doubts(footing + load, sand), Keys{});
  EXPECT_EQ(doubts(footing + load, with(sand, {"soil.friction_angle=0.52"})), Keys{"friction"});
  EXPECT_EQ(scenario(footing + load, with(sand, {"soil.friction_angle=0.52"})).doubts[0].sentence,
            "a friction angle of 0.52 degrees is nearly zero; if radians are meant, write 29.79");
}

TEST(Scenario, RefusesInitialStressOutsideOfTheFailureSurface) {
  const auto stress = [](const std::string& stress, const std::string& cohesion = "0") {
    return scenario(footing + load, with(sand, {"soil.initial_stress=" + stress, "soil.cohesion=" + cohesion}));
  };
  // K_p is 3 at 30 degrees, and 2 c sqrt(K_p) is 34.64 kPa for a cohesion of 10 kPa.
  EXPECT_NO_THROW(stress("[100e3, 300e3, 100e3]"));
  EXPECT_NO_THROW(stress("[100e3, 334e3, 100e3]", "10e3"));
  EXPECT_NO_THROW(stress("[-17e3, -17e3, -17e3]", "10e3"));
  expect_error<DataError>([&] { stress("[100e3, 500e3, 300e3]"); },
                          "soil.initial_stress: has 500 kPa beside 100 kPa, outside of the failure surface: a friction "
                          "angle of 30 deg and a cohesion of 0 kPa bear 300 kPa there; give stresses closer to each "
                          "other, or a stronger soil");
  expect_error<DataError>([&] { stress("[100e3, 336e3, 100e3]", "10e3"); }, "bear 334.6 kPa there");
  expect_error<DataError>([&] { stress("[-10e3, -10e3, -10e3]"); },
                          "soil.initial_stress: has a tension of 10 kPa, and a friction angle of 30 deg and a cohesion "
                          "of 0 kPa bear 0 kPa; compression is positive: give stresses that the soil bears, or more "
                          "cohesion");
  expect_error<DataError>([&] { stress("[0, 0, -18e3]", "10e3"); }, "bear 17.32 kPa");
}

TEST(Scenario, DoubtsTractionsThatPullSoilWithoutTension) {
  const std::string pull = "[[traction]]\non = \"top\"\ny = 1000\n";
  EXPECT_EQ(doubts(footing + pull), Keys{}) << "an elastic soil bears tension";
  EXPECT_EQ(doubts(footing + pull, with(sand, {"soil.cohesion=1000"})), Keys{});
  EXPECT_EQ(doubts(footing + pull, sand), Keys{"traction_pulls"});
  EXPECT_EQ(scenario(footing + pull, sand).doubts[0].sentence,
            "the traction on \"top\" pulls the soil by 1 kPa, and it bears 0 kPa: it is torn apart; change the sign "
            "where a pressure is meant");
  EXPECT_EQ(doubts(footing + "[[traction]]\non = \"right\"\nx = 10\n", sand), Keys{"traction_pulls"});
  EXPECT_EQ(doubts(footing + "[[traction]]\non = \"left\"\nx = 10\n", sand), Keys{}) << "pushes";
  EXPECT_EQ(doubts(footing + "[[traction]]\non = \"top\"\nx = 10\n", sand), Keys{}) << "shears";
  EXPECT_EQ(doubts(footing + load + pull, sand), Keys{}) << "both add up to nothing";
  const std::string grains =
      "[mesh]\nwidth = 1\nheight = 1\ncolumns = 2\nrows = 2\n[soil]\nmaterial = \"grains\"\n"
      "[time]\nduration = 0.2\noutput_interval = 0.1\n"
      "[contact]\nlaw = \"linear\"\nyoung_modulus = 1e9\nstiffness_ratio = 0.2\nfriction_angle = 16\n";
  const std::vector<Doubt> found = read_scenario(grains + footing + pull, "test.toml", {}, std::nullopt).doubts;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].key, "traction_pulls");
}

Keys keys_in(const Doubts& doubts) {
  Keys keys;
  for (const Doubt& doubt : doubts.all()) keys.push_back(doubt.key);
  return keys;
}

Keys before(const std::string& text, const std::vector<std::string>& overrides) {
  Doubts doubts;
  const std::string forecasted = forecast(scenario(text, overrides), {}, doubts);
  EXPECT_NE(forecasted.find(" points, "), std::string::npos) << forecasted;
  return keys_in(doubts);
}

Keys timing(const std::vector<std::string>& overrides) { return before(footing + load, overrides); }

TEST(Scenario, DoubtsADurationInWhichNoLoadGetsThroughTheSoil) {
  // E = 10 MPa, nu = 0.25 and 2000 kg/m3: compression waves have 77.5 m/s.
  EXPECT_EQ(timing({}), Keys{});
  EXPECT_EQ(timing({"time.duration=0.012", "time.step=1e-4"}), Keys{"wave"});
  EXPECT_EQ(timing({"time.duration=0.014", "time.step=1e-4"}), Keys{});
  EXPECT_EQ(timing({"mesh.width=1000", "mesh.height=1000"}), (Keys{"wave", "few_steps"})) << "a mesh in mm";
  EXPECT_EQ(timing({"mesh.width=1000", "mesh.height=1000", "quasi_static.soil_damping=100"}), Keys{})
      << "comes to rest at its outputs";
  Doubts doubts;
  EXPECT_NE(forecast(scenario(footing + load, {"mesh.width=1000"}), {}, doubts).find(" points, 1000 m by 1 m\n"),
            std::string::npos);
}

TEST(Scenario, DoubtsLoadsThatTheInitialStressDoesNotBalance) {
  const Keys missed = {"load_unbalanced"};
  const auto with_stress = [](const std::string& stress, const std::string& text) {
    return before(footing + text, {"soil.initial_stress=" + stress});
  };
  EXPECT_EQ(with_stress("[500, 1000, 500]", load), Keys{});
  EXPECT_EQ(with_stress("[500, 1085, 500]", load), Keys{});
  EXPECT_EQ(with_stress("[500, 1150, 500]", load), missed);
  EXPECT_EQ(with_stress("[0, 0, 500]", load), Keys{}) << "no stress in the plane";
  EXPECT_EQ(with_stress("[500, 2000, 500]", load + load), Keys{}) << "tractions on one boundary add up";
  EXPECT_EQ(with_stress("[500, 1000, 500]", load + load), missed);
  EXPECT_EQ(with_stress("[500, 0, 500]", "[[traction]]\non = \"left\"\nx = 500\n"), Keys{});
  EXPECT_EQ(with_stress("[500, 0, 500]", "[[traction]]\non = \"right\"\nx = 500\n"), missed) << "the other sign";
  EXPECT_EQ(with_stress("[500, 0, 500]", "[[traction]]\non = \"bottom\"\ny = 500\n"), Keys{}) << "held";
}

TEST(Scenario, DoubtsSoilThatIsNotAtRestAtTheEndInEveryPhase) {
  const auto after = [](const std::string& text, const std::vector<std::string>& overrides) {
    const Ranks ranks;
    Doubts doubts;
    const Scenario plan = scenario(text, with({"soil.damping=0.2"}, overrides));
    doubts.add_all(plan.doubts);
    run(plan, {}, nullptr, {}, {}, ranks, doubts);
    return keys_in(doubts);
  };
  // The period of the block is about 0.05 s.
  for (const char* time : {"0.2", "0.21", "0.22", "0.23", "0.24", "0.25"})
    EXPECT_EQ(after(footing + load, {"time.duration=" + std::string(time)}), Keys{"unrest"}) << time;
  EXPECT_EQ(after(footing + load, {"soil.damping=150"}), Keys{});
  EXPECT_EQ(after(footing + load, {"soil.damping=1e5"}), Keys{"unrest"}) << "creeps towards its rest";
  EXPECT_EQ(after(footing + load, {"quasi_static.kinetic_energy=1e-6"}), Keys{});
  EXPECT_EQ(after(footing + load, {"quasi_static.kinetic_energy=1"}), Keys{"unrest"}) << "too much counts as rest";
  EXPECT_EQ(after(footing + "[[support]]\non = \"top\"\ny = -0.001\n", {}), Keys{}) << "driven";
  EXPECT_EQ(after(load, {}), Keys{"soil_free"}) << "nothing holds it";
}

TEST(Scenario, DoubtsSoilThatIsDrivenFasterThanItFollows) {
  const auto after = [](double speed, double duration, const std::string& further = "") {
    const Ranks ranks;
    Doubts doubts;
    const Scenario plan = scenario(footing + fmt::format("[[support]]\non = \"top\"\ny = {}\n", speed) + further,
                                   {"soil.damping=1", "time.safety=0.1", fmt::format("time.duration={}", duration)});
    run(plan, {}, nullptr, {}, {}, ranks, doubts);
    return keys_in(doubts);
  };
  // The period of the block is about 0.05 s.
  EXPECT_EQ(after(-0.1, 0.02), Keys{"inertia"});
  EXPECT_EQ(after(-0.01, 0.2), Keys{}) << "as far in ten times the time";
  EXPECT_EQ(after(-0.1, 0.02, "[quasi_static]\nkinetic_energy = 1e-6\n"), Keys{});
}

TEST(Scenario, RefusesPackingsForAContinuum) {
  Doubts doubts;
  expect_error<DataError>([&] { forecast(scenario(footing + load), {io::Snapshot{}}, doubts); },
                          "1 packing is given, and the soil is a continuum, which holds none");
}

TEST(Scenario, RefusesToRecordTheGrainsOfAContinuum) {
  refused(footing + load + "[record]\npoints = [1]\n", "record.points: names points whose grains are recorded");
  EXPECT_NO_THROW(scenario(footing + load + "[record]\npoints = []\n"));
}

std::vector<double> times(const std::vector<std::string>& overrides) {
  const Ranks ranks;
  Doubts doubts;
  return run(scenario(footing + load, overrides), {}, nullptr, {}, {}, ranks, doubts).file.series.at("time").values;
}

TEST(Scenario, RunsForItsDurationWithAShorterLastInterval) {
  EXPECT_EQ(times({}).size(), 3U);
  EXPECT_DOUBLE_EQ(times({}).back(), 0.2);
  const std::vector<double> once = times({"time.output_interval=5"});
  ASSERT_EQ(once.size(), 2U);
  EXPECT_DOUBLE_EQ(once[1], 0.2);
  const std::vector<double> shorter = times({"time.output_interval=0.15"});
  ASSERT_EQ(shorter.size(), 3U);
  EXPECT_DOUBLE_EQ(shorter[1], 0.15);
  EXPECT_NEAR(shorter[2], 0.2, 1e-3) << "to the nearest step";
  EXPECT_EQ(times({"time.output_interval=0.066666"}).size(), 4U) << "the rest of rounded decimals is no interval";
  // A fixed step that does not divide the interval: outputs are due at the nearest steps.
  const std::vector<double> fixed = times({"time.step=0.0003", "time.output_interval=0.05"});
  ASSERT_EQ(fixed.size(), 5U);
  for (std::size_t k = 0; k < fixed.size(); ++k) EXPECT_NEAR(fixed[k], 0.05 * static_cast<double>(k), 0.00015 + 1e-12);
  // An interval shorter than a step: an output after each.
  EXPECT_EQ(times({"time.step=0.001", "time.duration=0.005", "time.output_interval=0.0001"}).size(), 6U);
}

}  // namespace
}  // namespace soilweave::fem
