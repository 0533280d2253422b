// Checkpoints: a simulation goes on from any step to the same bits, counts and clocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "core/archive.h"
#include "core/stop_signals.h"
#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/run/run.h"
#include "files/files.h"
#include "files/part.h"
#include "packing/expand/tile.h"
#include "support/assemblies.h"
#include "support/long_run.h"
#include "support/same_state.h"

namespace soilweave::dem {
namespace {

namespace fs = std::filesystem;

Model bouncing_sand() {
  Model model = support::sand();
  auto& material = model.materials.of<HertzMindlin::Material>()[0];
  material.restitution = 0.7;
  return model;
}

// A simulation with motion of every kind: straining, shearing, gravity, moving planes, grains that roll and part.
struct Moving {
  explicit Moving(const Model& m, int dimension) : model(m), start(support::packed(m, 1e5, 130, dimension)) {
    start.cell.periodic[0] = false;
    const Vec3 slanted = dimension == 3 ? Vec3(1, 0.02, 0.01) : Vec3(1, 0.02, 0);
    start.planes.point = {Vec3(-4e-3, 0, 0)};
    start.planes.normal = {slanted.normalized()};
    start.planes.velocity = {Vec3(1e-2, 0, 0)};
    start.planes.material_id = {0};
    numerics.gravity = Vec3(0, -9.81, 0);
    gradient.diagonal() = Vec3(0, -0.1, dimension == 3 ? 0.05 : 0);
    gradient(0, 1) = 0.02;
  }

  Model model;
  io::Snapshot start;
  Numerics numerics;
  Mat3 gradient = Mat3::Zero();
};

Simulation copy(const Simulation& simulation, const Moving& moving) {
  Archive kept;
  simulation.archive(kept);
  Archive given(kept.numbers(), "memory");
  return {simulation.snapshot(), moving.model, moving.numerics, given};
}

void expect_same(const Simulation& a, const Simulation& b) {
  io::test::expect_same(a.snapshot(), b.snapshot());
  EXPECT_EQ(a.time_step(), b.time_step());
  EXPECT_EQ(a.contact_steps(), b.contact_steps());
  EXPECT_EQ(a.measures().stress, b.measures().stress);
  EXPECT_EQ(a.measures().axial_stiffness, b.measures().axial_stiffness);
  EXPECT_EQ(a.unbalanced_force(), b.unbalanced_force());
  EXPECT_EQ(a.energies()["boundary_work"], b.energies()["boundary_work"]);
  EXPECT_EQ(a.energies().error(), b.energies().error());
}

TEST(Resume, GoesOnFromAnyStepToTheSameBits) {
  for (const Model& model : {support::sand(), support::linear_sand(), bouncing_sand()})
    for (const int dimension : {3, 2}) {
      const Moving moving(model, dimension);
      Simulation whole(moving.start, model, moving.numerics);
      whole.set_velocity_gradient(moving.gradient);
      Simulation resumed = copy(whole, moving);
      for (int k = 1; k <= 120; ++k) {
        whole.step();
        resumed.step();
        // Steps are multiples of eight, when the stiffness is evaluated, and have every other remainder.
        if (k % 5 != 0) continue;
        expect_same(whole, resumed);
        resumed = copy(resumed, moving);
        expect_same(whole, resumed);
      }
    }
}

TEST(Resume, OfAGrainInACornerKeepsAllItsPlanes) {
  Moving moving(support::sand(), 3);
  io::Snapshot& start = moving.start;
  // Two grains are far from each other, one of them in the corner.
  const auto by_sum = [](const Vec3& a, const Vec3& b) { return a.sum() < b.sum(); };
  const auto& all = moving.start.grains.position;
  const auto [low, high] = std::minmax_element(all.begin(), all.end(), by_sum);
  const Vec3 corner = *low, far = *high;
  start = packing::filter(start, [&](std::size_t i) { return all[i] == corner || all[i] == far; });
  const std::int32_t grain = start.grains.position[0] == corner ? 0 : 1;
  start.grains.velocity.assign(2, Vec3::Zero());
  start.cell.periodic = {false, false, false};
  start.planes = {};
  for (int a = 0; a < 3; ++a) {
    const double reach = 0.999 * start.grains.radius[static_cast<std::size_t>(grain)];
    start.planes.point.emplace_back(corner - Vec3::Constant(reach));
    start.planes.normal.emplace_back(Vec3::Unit(a)), start.planes.velocity.emplace_back(1e-2, 2e-2, 0);
    start.planes.material_id.push_back(0);
  }
  Simulation first(start, moving.model, moving.numerics);
  for (int k = 0; k < 4; ++k) first.step();
  const io::Snapshot state = first.snapshot();
  const auto touches = [&](std::int32_t plane) {
    return std::count(state.contacts.bodies.begin(), state.contacts.bodies.end(), std::array{grain, -1 - plane});
  };
  ASSERT_EQ(touches(0) + touches(1) + touches(2), 3);
  EXPECT_NO_THROW(io::check(state, "corner"));
  Simulation second = copy(first, moving);
  for (int k = 0; k < 20; ++k) first.step(), second.step();
  expect_same(first, second);
}

TEST(Archive, GivesBackWhatItKept) {
  double number = 0.1;
  std::int64_t whole = -(std::int64_t{1} << 52);
  Vec3 vector(1, -0.0, 3e-320);
  std::vector<double> list = {1, 2};
  Archive kept;
  kept.item("number", number), kept.item("whole", whole), kept.item("vector", vector), kept.item("list", list);
  Archive given(kept.numbers(), "here");
  double number_back = 0;
  std::int64_t whole_back = 0;
  Vec3 vector_back = Vec3::Zero();
  std::vector<double> list_back;
  given.item("number", number_back), given.item("whole", whole_back);
  given.item("vector", vector_back), given.item("list", list_back);
  EXPECT_EQ(number, number_back);
  EXPECT_EQ(whole, whole_back);
  EXPECT_EQ(std::memcmp(vector.data(), vector_back.data(), sizeof(Vec3)), 0);
  EXPECT_EQ(list, list_back);
  io::test::expect_error<DataError>([&] { given.item("other", number); }, "here: keeps no other");
  io::test::expect_error<DataError>([&] { given.item("vector", number); }, "here: keeps 3 numbers of vector");
}

TEST(Archive, RefusesNumbersThatWereChanged) {
  const auto refused = [](std::vector<double> kept, const auto& take, const std::string& words) {
    Archive given({{"n", std::move(kept)}}, "file");
    io::test::expect_error<DataError>([&] { take(given); }, words);
  };
  const auto whole = [](Archive& a) {
    std::size_t n = 0;
    a.whole("n", n);
  };
  const auto two = [](Archive& a) {
    std::vector<double> values(2);
    a.sized("n", values);
  };
  refused({std::nan("")}, whole, "file: keeps a n that is not a number");
  refused({0.5}, whole, "which is no whole number");
  refused({1e300}, whole, "give --force without --resume to begin anew");
  refused({1, 2, 3}, two, "keeps 3 numbers of n where 2 belong");
}

class PartTest : public ::testing::Test {
 protected:
  PartTest() : folder_(fs::temp_directory_path() / ("soilweave-part-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~PartTest() override { fs::remove_all(folder_); }

  static io::Checkpoint checkpoint(std::int64_t step) {
    static const io::Snapshot state = support::packed(support::sand(), 1e5, 20);
    io::Checkpoint m{state, {}, {{"number", {static_cast<double>(step)}}}};
    m.state.step = step;
    m.series.columns = {{"step", "1", "steps", {0, static_cast<double>(step)}}};
    return m;
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "out.h5.part"))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  io::Part part(io::Part::Entry entry = io::Part::Entry::resume) const { return {folder_ / "out.h5", history_, entry}; }

  fs::path folder_;
  io::History history_ = {{"run-dem", "1", "run-dem", "", 0, {}}};
};

TEST_F(PartTest, KeepsRecordedStatesAndTheLastTwoFiles) {
  auto kept = part();
  EXPECT_FALSE(kept.take_last());
  kept.keep(checkpoint(0), true);
  kept.keep(checkpoint(10), false);
  kept.keep(checkpoint(20), true);
  for (const std::int64_t step : {30, 40, 50}) kept.keep(checkpoint(step), false);
  EXPECT_EQ(files(), (std::vector<std::string>{"checkpoint-000000000040.h5", "checkpoint-000000000050.h5",
                                               "state-000000000000.h5", "state-000000000020.h5"}));
  const std::vector<io::Snapshot> states = kept.recorded();
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[1].step, 20);
  io::test::expect_same(states[0], checkpoint(0).state);
}

TEST_F(PartTest, GoesOnFromTheNewestFileThatIsWhole) {
  {
    auto kept = part();
    kept.keep(checkpoint(0), true);
    for (const std::int64_t step : {30, 40}) kept.keep(checkpoint(step), false);
  }
  std::ofstream(folder_ / "out.h5.part/.state-000000000050.h5.1.tmp") << "half";
  fs::resize_file(folder_ / "out.h5.part/checkpoint-000000000040.h5", 500);
  auto resumed = part();
  const auto last = resumed.take_last();
  ASSERT_TRUE(last);
  io::test::expect_same(last->state, checkpoint(30).state);
  io::test::expect_same(last->series, checkpoint(30).series);
  EXPECT_EQ(last->numbers.at("number"), std::vector<double>{30});
  EXPECT_EQ(files(), (std::vector<std::string>{"checkpoint-000000000030.h5", "state-000000000000.h5"}));
}

TEST_F(PartTest, GoesBackBeyondARecordedStateThatIsMissing) {
  {
    auto kept = part();
    for (const std::int64_t step : {0, 10, 20}) kept.keep(checkpoint(step), true);
  }
  fs::remove(folder_ / "out.h5.part/state-000000000010.h5");
  auto resumed = part();
  EXPECT_EQ(resumed.last_step(), 0);
}

TEST_F(PartTest, RefusesAnotherRunAndWorkThatWouldBeLost) {
  { part().keep(checkpoint(10), true); }
  io::test::expect_error<CannotCreate>([&] { part(io::Part::Entry::fresh); }, "holds an unfinished run, at step 10");
  history_[0].seed = 1;
  io::test::expect_error<DataError>([&] { part(); }, "is of a run whose seed differs");
  EXPECT_EQ(part(io::Part::Entry::resume_or_anew).last_step(), -1);
}

TEST_F(PartTest, FollowsNoLinkOutOfItsFolder) {
  { part().keep(checkpoint(10), false); }
  const fs::path kept = folder_ / "out.h5.part/checkpoint-000000000010.h5", far = folder_ / "far.h5";
  fs::rename(kept, far);
  fs::create_symlink(far, kept);
  EXPECT_EQ(part().last_step(), -1);
  part().keep(checkpoint(10), false);
  EXPECT_FALSE(fs::is_symlink(kept));
  EXPECT_TRUE(fs::is_regular_file(far));
  fs::rename(folder_ / "out.h5.part", folder_ / "elsewhere");
  fs::create_directory_symlink("elsewhere", folder_ / "out.h5.part");
  io::test::expect_error<CannotCreate>([&] { part(); }, "is a link");
}

// The error is not about the file, since a resumed run would compute the same state again.
TEST_F(PartTest, AStateThatNoFileMayHoldIsTheRunsOwnFault) {
  auto kept = part();
  io::Checkpoint wrong = checkpoint(7);
  wrong.state.grains.orientation[2] *= 1.1;
  io::test::expect_error<PhysicsError>([&] { kept.keep(wrong, false); }, "step 7: the state cannot be kept");
}

TEST_F(PartTest, BelongsToOneProcess) {
  auto held = part();
  held.keep(checkpoint(0), true);
  io::test::expect_error<CannotCreate>([&] { part(); }, "another process is at work on this run");
}

TEST_F(PartTest, NamesAWayToGoOnWhereThereIsOne) {
  const auto kept = part();
  EXPECT_STREQ(kept.explained(IoError("disk full")).what(), "disk full; nothing is kept yet: run it again");
  EXPECT_STREQ(kept.explained(DataError("too few grains")).what(), "too few grains");
}

TEST_F(PartTest, LeavesAStateThatIsBrokenToBeLookedAt) {
  auto kept = part();
  kept.keep(checkpoint(0), true);
  io::Snapshot broken = checkpoint(7).state;
  broken.grains.position[3].y() = std::nan("");
  const Error error = kept.stopped(PhysicsError("step 7: broken"), broken);
  EXPECT_EQ(error.status(), Exit::internal);
  const fs::path left = folder_ / "out.h5.part/stopped.h5";
  EXPECT_EQ(std::string(error.what()), "step 7: broken; " + left.string() + " shows it (to-vtk); " +
                                           kept.last().string() + " is the last good state");
  EXPECT_EQ(io::read_state(left).state.grains.size(), broken.grains.size() - 1);
}

// Steps of a station count from the start of its loading, even if the run was stopped on the way.
TEST_F(PartTest, CountsTheStepsOfAStationFromItsOwnBeginning) {
  const auto plan = [](std::int64_t most) {
    return read_scenario(
        "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = \"4 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 29\n"
        "[[stage]]\nname = \"one\"\npath = \"isotropic\"\npressure = 1.5e5\n"
        "[[stage]]\nname = \"two\"\npath = \"triaxial\"\nconfining_pressure = 1.5e5\naxial_strain = 0.02\n"
        "increment = 0.02\n[equilibrium]\nsteps = " +
            std::to_string(most),
        "test", {});
  };
  const Scenario free = plan(100000);
  const io::Snapshot start = prepare(support::packed(free.model, 1e5, 60), free);
  const Outcome whole = run(start, free, {});
  const std::vector<double>& step = whole.file.series.at("step").values;
  ASSERT_EQ(step.size(), 3U);
  ASSERT_GT(step[2] - step[1], 1000) << "a report comes every 512 steps of a way";
  {
    auto kept = part();
    const StopSignals signals;
    const auto stop_in_two = [](double, const std::string& detail) {
      if (detail.starts_with("two")) std::raise(SIGTERM);
    };
    EXPECT_THROW(run(start, free, stop_in_two, {&kept, 300, &signals}), Error);
  }
  const Scenario bounded = plan(static_cast<std::int64_t>(step[2] - step[1]) + 1);
  auto resumed = part();
  ASSERT_GT(resumed.last_step(), static_cast<std::int64_t>(step[1])) << "it was stopped within the second stage";
  const Outcome rest = run(start, bounded, {}, {&resumed, 300, nullptr});
  io::test::expect_same(rest.file.series, whole.file.series);
  EXPECT_EQ(static_cast<double>(rest.cost.steps), step[2]);
  EXPECT_EQ(rest.cost.contact_steps, whole.cost.contact_steps);
}

TEST(Resume, GoesOnAtTheStepAndTimeOfItsState) {
  io::Snapshot state = support::packed(support::sand(), 1e5, 20);
  state.step = 500, state.time = 0.25;
  Simulation s(state, support::sand(), {});
  const double dt = s.time_step();
  for (int k = 0; k < 3; ++k) s.step();
  EXPECT_EQ(s.steps(), 503);
  EXPECT_EQ(s.snapshot().step, 503);
  EXPECT_NEAR(s.time(), 0.25 + 3 * dt, 1e-15);
}

TEST(LongRun, OfAPackingAtRestDriftsByRoundingAlone) { support::expect_no_drift(100, 10'000); }

}  // namespace
}  // namespace soilweave::dem
