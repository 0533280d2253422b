// Doubts: said once, kept in the file that a run writes, absent from files without any.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/doubts.h"

#include <gtest/gtest.h>

#include "analysis/tables/doubts.h"
#include "dem/run/cost.h"
#include "files/files.h"
#include "gws/solution/doubts.h"
#include "support/assembly.h"
#include "support/states.h"

namespace soilweave {
namespace {

const Doubt many_rattlers{"rattlers", "43 % of the grains bear nothing, over 15 %"};

io::History made_by(const std::string& tool) {
  tool::Invocation invocation;
  invocation.tool = tool, invocation.version = "1.0.0", invocation.command = tool;
  return io::extend({}, invocation);
}

TEST(Doubts, AreSaidOnceEachAndKeptInOrder) {
  testing::internal::CaptureStderr();
  Doubts doubts("run-dem");
  doubts.add(many_rattlers);
  doubts.add_all({{"isotropy", "q/p is 0.2"}, {"rattlers", "44 % of the grains bear nothing, over 15 %"}});
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "run-dem: doubt: 43 % of the grains bear nothing, over 15 %\nrun-dem: doubt: q/p is 0.2\n");
  ASSERT_EQ(doubts.all().size(), 2U);
  EXPECT_EQ(doubts.all()[0], many_rattlers);
  EXPECT_EQ(doubts.all()[1].key, "isotropy");
}

TEST(Doubts, OfSeveralStatesTellTheirNumber) {
  const std::vector<Doubt> said = one_a_key({{"empty", "step 0: 5"},
                                             {"empty", "step 0: 5"},
                                             {"empty", "step 9: 7"},
                                             {"none", "step 9: x"},
                                             {"empty", "step 12: 5"}},
                                            "states");
  EXPECT_EQ(said,
            (std::vector<Doubt>{{"empty", "step 0: 5; this concerns 2 more of the states"}, {"none", "step 9: x"}}));
}

TEST(Doubts, OfASilentProcessAreKeptAlone) {
  testing::internal::CaptureStderr();
  Doubts doubts;
  doubts.add(many_rattlers);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(doubts.all().size(), 1U);
}

TEST(Doubts, LieInTheRecordOfTheRunThatWroteTheFile) {
  const io::test::Folder folder;
  const io::Snapshot state = io::test::example_state();
  Doubts doubts;
  doubts.add(many_rattlers);
  doubts.add({"isotropy", "q/p is 0.2"});
  const io::History plain = made_by("pack-generate");
  io::write_packing(folder / "doubtful.h5", state, io::with_doubts(plain, doubts));
  io::write_packing(folder / "plain.h5", state, plain);
  io::write_packing(folder / "none.h5", state, io::with_doubts(plain, {}));
  const io::History read = io::read_history(folder / "doubtful.h5");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read.back().doubts, doubts.all());
  EXPECT_NE(io::describe(read).find("  doubt: rattlers: 43 % of the grains bear nothing, over 15 %\n"),
            std::string::npos);
  EXPECT_EQ(io::describe(io::without_doubts(read)), io::describe(plain));
  EXPECT_EQ(io::test::bytes_of(folder / "plain.h5"), io::test::bytes_of(folder / "none.h5"));
  EXPECT_NE(io::test::bytes_of(folder / "plain.h5"), io::test::bytes_of(folder / "doubtful.h5"));
}

TEST(Doubts, OfAnInputStayInItsRecord) {
  Doubts doubts;
  doubts.add(many_rattlers);
  tool::Invocation invocation;
  invocation.tool = "run-dem";
  const io::History history =
      io::extend({{"packing", "aa", io::with_doubts(made_by("pack-generate"), doubts)}}, invocation);
  ASSERT_EQ(history.size(), 2U);
  EXPECT_EQ(history[0].doubts, doubts.all());
  EXPECT_TRUE(history[1].doubts.empty());
  EXPECT_EQ(io::without_doubts(history)[0].doubts, doubts.all());
}

using analysis::test::add_grain;
using analysis::test::simple_cubic;

std::string sentence_of(const std::vector<Doubt>& doubts, const std::string& key) {
  for (const Doubt& doubt : doubts)
    if (doubt.key == key) return doubt.sentence;
  return "";
}

TEST(DoubtsOfPackings, CellThatIsNarrowForItsLargestGrain) {
  EXPECT_TRUE(analysis::cell_doubts(simple_cubic(4, Vec3(1, 1, 1))).empty());
  EXPECT_TRUE(analysis::cell_doubts(simple_cubic(4, Vec3(1, 1, 0), 2)).empty());
  const std::string said = sentence_of(analysis::cell_doubts(simple_cubic(3, Vec3(1, 1, 1))), "cell-over-grain");
  EXPECT_NE(said.find("3 diameters of the largest grain (1 m) wide along x, below 4"), std::string::npos) << said;
  EXPECT_NE(said.find("take 3 times the grains"), std::string::npos) << said;  // (4/3)^3
  io::Snapshot open = simple_cubic(3, Vec3(1, 1, 1));
  open.cell.periodic = {false, false, false};
  EXPECT_TRUE(analysis::cell_doubts(open).empty());
}

TEST(DoubtsOfPackings, OpenCellsHaveARemedyThatSuitsThem) {
  io::Snapshot state = simple_cubic(3, Vec3(1, 1, 1));
  const auto said = [&](std::string_view table = "cell") {
    return sentence_of(analysis::open_cell_doubts(state, table), "open-cell");
  };
  EXPECT_EQ(said(), "");
  state.cell.periodic = {true, true, false};
  EXPECT_NE(said().find("take displacement and force of named planes from --table series"), std::string::npos);
  EXPECT_NE(said("series").find("take displacement and force of named planes alone (--columns)"), std::string::npos);
  state.cell.periodic = {false, false, false};
  EXPECT_NE(said().find("--table volumes with a --box among the grains; or displacement"), std::string::npos);
}

TEST(DoubtsOfPackings, VolumesOfFewGrains) {
  const io::Snapshot state = simple_cubic(5, Vec3(1, 1, 1));
  const analysis::Volume all = analysis::whole(state), four{"four", {0, 1, 2, 3}, {}};
  EXPECT_TRUE(analysis::volume_doubts(state, {all}).empty());
  EXPECT_TRUE(analysis::volume_doubts(state, {}).empty());
  EXPECT_NE(
      sentence_of(analysis::volume_doubts(state, {all, four}), "few-grains").find("grains in four: 4, fewer than 64"),
      std::string::npos);
}

TEST(DoubtsOfPackings, RattlersCoordinationAndIsotropy) {
  EXPECT_TRUE(analysis::compaction_doubts(simple_cubic(3, Vec3(1, 1, 1))).empty());
  // q/p of the stresses 1, 1 and 2 is 1 / (4/3).
  const auto uneven = analysis::compaction_doubts(simple_cubic(3, Vec3(1, 1, 2)));
  ASSERT_EQ(uneven.size(), 1U);
  EXPECT_NE(sentence_of(uneven, "isotropy").find("q/p is 0.75"), std::string::npos);
  io::Snapshot loose = simple_cubic(3, Vec3(1, 1, 1));
  for (int k = 0; k < 10; ++k) add_grain(loose, Vec3(0.5, 0.5, 0.5), 0.1);
  const auto floating = analysis::compaction_doubts(loose);
  ASSERT_EQ(floating.size(), 1U);
  EXPECT_NE(sentence_of(floating, "rattlers").find("27 % of the grains"), std::string::npos);
  for (int k = 0; k < 20; ++k) add_grain(loose, Vec3(0.5, 0.5, 0.5), 0.1);
  EXPECT_NE(sentence_of(analysis::compaction_doubts(loose), "coordination").find("2 Nc/N is 2.84"), std::string::npos);
  io::Snapshot bare = simple_cubic(3, Vec3(1, 1, 1));
  bare.contacts = {};
  EXPECT_TRUE(analysis::compaction_doubts(bare).empty());
}

// Soil in a box of nodes, joined by yarns to one bag.
io::Snapshot bag() {
  io::Snapshot s = simple_cubic(3, Vec3(1, 1, 1));
  s.cell.periodic = {false, false, false};
  for (const double x : {-1.0, 3.0})
    for (const double y : {-1.0, 3.0})
      for (const double z : {-1.0, 3.0}) add_grain(s, Vec3(x, y, z), 0.05);
  for (std::int32_t k = 0; k + 1 < 8; ++k) s.yarns.nodes.push_back({27 + k, 28 + k});
  return s;
}

TEST(DoubtsOfBags, GrainsOutsideAndSoilThatBearsNothing) {
  EXPECT_TRUE(analysis::bag_doubts(bag()).empty());
  io::Snapshot out = bag();
  out.grains.position[26] = Vec3(1, 1, 4);
  EXPECT_NE(sentence_of(analysis::bag_doubts(out), "outside").find("1 of 27 grains"), std::string::npos);
  io::Snapshot bare = bag();
  bare.contacts = {};
  EXPECT_NE(sentence_of(analysis::bag_doubts(bare), "preload").find("2 Nc/N of the soil in the bag is 0"),
            std::string::npos);
  EXPECT_TRUE(analysis::bag_doubts(simple_cubic(3, Vec3(1, 1, 1))).empty());
}

TEST(DoubtsOfRuns, InertialNumberWithTheRateThatWouldDo) {
  // 10 %/s, 6 mm, density scaled a thousand times, 100 kPa.
  EXPECT_NEAR(analysis::inertial_number(0.1, 6e-3, 2650e3, 1e5), 3.089e-3, 1e-6);
  const io::Snapshot start = simple_cubic(4, Vec3(1, 1, 1));  // 1 m, 1 kg: 6/pi kg/m3
  const auto of = [&](const std::string& rate) {
    const dem::Scenario plan = dem::read_scenario(
        "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = 1e9\npoisson_ratio = 0.3\nfriction_angle = 30\n"
        "[[stage]]\npath = \"isotropic\"\npressure = 1e5\n[[stage]]\nname = \"shear\"\npath = \"triaxial\"\n"
        "confining_pressure = 1e5\naxial_strain = 0.1\nrate = " +
            rate + "\n",
        "test.toml", {});
    return sentence_of(analysis::doubts_before(start, plan, start), "inertia");
  };
  const std::string said = of("0.1");
  EXPECT_NE(said.find("stage \"shear\" at 0.1 1/s: inertial number 4.4e-04"), std::string::npos) << said;
  EXPECT_NE(said.find("a rate of 0.02 1/s is slow enough"), std::string::npos) << said;
  EXPECT_EQ(of("0.02"), "");  // the remedy works
}

TEST(Cost, SharesOfPhasesAddUpToTheTimeOfStepping) {
  dem::Cost cost;
  cost.steps = 700, cost.stepping = 10, cost.output = 10;
  cost.times.looked_at = 100;
  cost.times.seconds = {2, 1, 1};  // 28 s for all steps, if the sampled ones were typical; they were slow ones
  EXPECT_DOUBLE_EQ(cost.share(dem::Phase::contacts), 0.25);
  EXPECT_DOUBLE_EQ(cost.share(dem::Phase::integration), 0.125);
  cost.times.seconds = {0.4, 0.2, 0.2};
  EXPECT_DOUBLE_EQ(cost.share(dem::Phase::contacts), 0.14);
}

TEST(DoubtsOfBagsSolved, SoilNobodyChoseAndConstantsExtrapolated) {
  gws::SoilFile soil;
  soil.name = "sand";
  soil.identified = {{5e4, 7e5}, {2e3, 2e6}, {0, 0.2}};
  gws::Point inside, outside;
  inside.soil.p = 1e5, inside.soil.strain_axial = 10;
  outside.soil.p = 4e6, outside.soil.strain_axial = 21;
  gws::Case asked;
  asked.bag = {0.4, 0.08};
  EXPECT_TRUE(gws::doubts(soil, true, asked, {1e5}, {inside}).empty());
  EXPECT_NE(sentence_of(gws::doubts(soil, false, asked, {1e5}, {inside}), "default-soil").find("the soil is sand"),
            std::string::npos);
  const std::string said = sentence_of(gws::doubts(soil, true, asked, {3e4}, {inside, outside}), "extrapolation");
  EXPECT_NE(said.find("stiffness of the geotextile 30 kN/m (identified on 50 to 700 kN/m), mean stress 4000 kPa"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("axial strain 21 %"), std::string::npos) << said;
  outside.soil.end = gws::End::flow;
  EXPECT_TRUE(gws::doubts(soil, true, asked, {1e5}, {outside}).empty());
  soil.identified = {};
  EXPECT_EQ(gws::doubts(soil, true, asked, {1}, {inside}).size(), 1U);
  EXPECT_NE(sentence_of(gws::doubts(soil, true, asked, {1}, {inside}), "unknown-range"), "");
}

TEST(DoubtsOfBagsSolved, ShapesAndLateralStressesThatNoGrainsWereRunWith) {
  gws::SoilFile soil;
  soil.identified = {{5e4, 7e5}, {2e3, 2e6}, {0, 0.2}};
  gws::Case asked;
  asked.bag = {0.08, 0.4}, asked.lateral = gws::LateralStress::constant(3e5);
  const std::string said = sentence_of(gws::doubts(soil, true, asked, {}, {}), "untested");
  EXPECT_NE(said.find("height over width 5 (simulated bags had 0.2), lateral stress 300 kPa"), std::string::npos)
      << said;
  asked.bag = {0.4, 0.1}, asked.lateral = gws::LateralStress::constant(1e5);
  EXPECT_TRUE(gws::doubts(soil, true, asked, {}, {}).empty());
  gws::Point begin;
  begin.lateral = 1e5, begin.hoop_tension = -1;
  EXPECT_NE(sentence_of(gws::doubts(soil, true, asked, {}, {begin}), "compressed").find("compresses the geotextile"),
            std::string::npos);
}

}  // namespace
}  // namespace soilweave
