// Packings, runs and fields come back bit by bit, and every fault of a file is reported in one line.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <functional>

#include "core/error.h"
#include "store/store.h"
#include "support/same_state.h"
#include "support/states.h"

#ifdef __SANITIZE_ADDRESS__
// HDF5 1.10 leaks memory when it gives up on damaged structure.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5\n"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace soilweave::io {
namespace {

using test::expect_error;
using test::expect_same;

class Files : public testing::Test {
 protected:
  test::Folder folder;
  std::filesystem::path path = folder / "file.h5";
};

TEST_F(Files, PackingComesBackBitForBit) {
  for (const int dimension : {2, 3})
    for (const bool planes : {false, true})
      for (const std::size_t grains : {2, 12, 3000}) {
        const Snapshot state = test::example_state(grains, dimension, planes);
        write_packing(path, state, test::example_history());
        const PackingFile back = read_state(path, "start");
        expect_same(state, back.state);
        expect_same(test::example_history(), back.source.history);
        EXPECT_EQ(back.source.role, "start");
        EXPECT_EQ(back.source.sha256, sha256(test::bytes_of(path)));
      }
}

TEST_F(Files, PackingWithoutContactsAndHistoryComesBack) {
  Snapshot state = test::example_state();
  state.contacts = {};
  write_packing(path, state, {});
  expect_same(state, read_state(path).state);
}

TEST_F(Files, RunComesBackBitForBit) {
  for (const bool planes : {false, true})
    for (const std::size_t grains : {12, 1500}) {
      const RunFile run = test::example_run(grains, planes);
      write_run(path, run, test::example_history());
      const RunFile back = read_states(path);
      ASSERT_EQ(back.snapshots.size(), run.snapshots.size());
      for (std::size_t f = 0; f < run.snapshots.size(); ++f) expect_same(run.snapshots[f], back.snapshots[f]);
      expect_same(run.series, back.series);
      EXPECT_EQ(run.scenario, back.scenario);
      EXPECT_EQ(run.work.steps, back.work.steps);
      EXPECT_EQ(run.work.contact_steps, back.work.contact_steps);
      expect_same(test::example_history(), back.source.history);
    }
}

TEST_F(Files, RunWhoseGrainsChangeTheirOrderComesBack) {
  RunFile run = test::example_run();
  std::swap(run.snapshots[1].grains.body_id[0], run.snapshots[1].grains.body_id[1]);
  run.snapshots[2].grains.material_id[4] = 7;
  write_run(path, run, {});
  const RunFile back = read_states(path);
  for (std::size_t f = 0; f < run.snapshots.size(); ++f) expect_same(run.snapshots[f], back.snapshots[f]);
}

FieldsFile example_fields() {
  FieldsFile fields;
  fields.groups = {{"volumes", "averages over volumes of interest", test::example_run().series},
                   {"empty", "a table without columns", {}},
                   {"bare", "columns without rows", {{{"x", "m", "place", {}}}}}};
  return fields;
}

TEST_F(Files, FieldsComeBackInTheirOrder) {
  const FieldsFile fields = example_fields();
  write_fields(path, fields, test::example_history());
  const FieldsFile back = read_fields(path);
  ASSERT_EQ(back.groups.size(), fields.groups.size());
  for (std::size_t k = 0; k < fields.groups.size(); ++k) {
    EXPECT_EQ(back.groups[k].name, fields.groups[k].name);
    EXPECT_EQ(back.groups[k].long_name, fields.groups[k].long_name);
    expect_same(fields.groups[k].table, back.groups[k].table);
  }
  expect_same(test::example_history(), back.source.history);
}

TEST_F(Files, EqualContentGivesEqualBytes) {
  const auto other = folder / "other.h5";
  write_run(path, test::example_run(1500), test::example_history());
  write_run(other, read_states(path), read_history(path));
  EXPECT_EQ(test::bytes_of(path), test::bytes_of(other));
  write_packing(path, test::example_state(), test::example_history());
  write_packing(other, test::example_state(), test::example_history());
  EXPECT_EQ(test::bytes_of(path), test::bytes_of(other));
}

TEST_F(Files, StatesComeFromPackingsAndRuns) {
  write_run(path, test::example_run(), {});
  expect_same(test::example_run().snapshots.back(), read_state(path).state);
  EXPECT_EQ(read_states(path).snapshots.size(), 3U);
  EXPECT_EQ(read_kind(path), "run");
  write_packing(path, test::example_state(), test::example_history());
  expect_same(test::example_state(), read_state(path).state);
  EXPECT_EQ(read_states(path).snapshots.size(), 1U);
  EXPECT_EQ(read_kind(path), "packing");
  expect_same(test::example_history(), read_history(path));
}

TEST_F(Files, WrongKindSaysBothKinds) {
  write_packing(path, test::example_state(), {});
  expect_error<DataError>([&] { read_multiscale(path); },
                          path.string() + ": holds packing, but multiscale is needed here");
  expect_error<DataError>([&] { read_fields(path); }, "holds packing, but fields is needed here");
  write_fields(path, example_fields(), {});
  expect_error<DataError>([&] { read_state(path); }, "holds fields, but packing or run is needed here");
}

TEST_F(Files, WhatIsNoFileOfOursIsToldApart) {
  expect_error<MissingInput>([&] { read_state(path); }, path.string() + ": no such file");
  expect_error<MissingInput>([&] { read_text(path, "scenario"); }, "no such file");
  expect_error<DataError>([&] { read_fields(folder.path()); }, ": a directory; name a file in it");
  test::put_bytes(path, "");
  expect_error<DataError>([&] { read_state(path); }, ": empty");
  test::put_bytes(path, "x y z r\n");
  expect_error<DataError>([&] { read_state(path); }, ": not an HDF5 file");
  Writer foreign;
  foreign.group("/data");
  test::put_bytes(path, foreign.image());
  expect_error<DataError>([&] { read_state(path); }, "none of soilweave's");
}

/// Returns a packing with one change; `change` writes in place of the part that is left out.
std::string head(const std::vector<std::int64_t>& version, const std::string& kind) {
  Writer file;
  file.attribute("/", "format", std::string("soilweave"));
  file.attribute("/", "kind", kind);
  file.attribute("/", "format_version", version);
  file.group("/provenance");
  return file.image();
}

TEST_F(Files, NewerMajorVersionIsRefusedAndNewerMinorRead) {
  test::put_bytes(path, head({2, 5}, "packing"));
  expect_error<DataError>([&] { read_state(path); }, "has the format version 2.5, this program reads 1.3 at most");
  test::put_bytes(path, head({1, 9}, "packing"));
  expect_error<DataError>([&] { read_state(path); }, "/particles/grains/box has no attribute dimension");
  test::put_bytes(path, head({1, 0}, "tapestry"));
  expect_error<DataError>([&] { read_state(path); }, "unknown kind \"tapestry\"");
}

TEST_F(Files, EveryTruncationIsTold) {
  write_run(path, test::example_run(), test::example_history());
  const std::string whole = test::bytes_of(path);
  for (std::size_t length = 0; length < whole.size(); length += length < 100 ? 1 : 97) {
    test::put_bytes(path, std::string_view(whole).substr(0, length));
    EXPECT_THROW(read_states(path), DataError) << length;
  }
}

/// After bit flips a file reads as it was, or the damage is reported. It never crashes and never gives other numbers.
TEST_F(Files, DamagedBytesNeverGiveOtherStates) {
  const RunFile run = test::example_run(60);
  write_run(path, run, test::example_history());
  const std::string whole = test::bytes_of(path);
  std::uint64_t random = 1;
  int told = 0;
  constexpr int trials = 400;
  for (int k = 0; k < trials; ++k) {
    std::string damaged = whole;
    for (int flips = k % 3 + 1; flips > 0; --flips) {
      random = random * 6364136223846793005ULL + 1442695040888963407ULL;
      damaged[(random >> 20) % damaged.size()] ^= static_cast<char>(1U << (random >> 61));
    }
    test::put_bytes(path, damaged);
    try {
      const RunFile back = read_states(path);
      ASSERT_EQ(back.snapshots.size(), run.snapshots.size());
      for (std::size_t f = 0; f < run.snapshots.size(); ++f) expect_same(run.snapshots[f], back.snapshots[f]);
    } catch (const DataError&) {
      ++told;
    }
  }
  // Bytes between objects and the long scenario text carry no checksum; most of the file does.
  EXPECT_GT(told, trials / 3);
}

// ---- Writing
// ---------------------------------------------------------------------------------------------------------

TEST_F(Files, FailedWritingLeavesTheFormerFile) {
  write_packing(path, test::example_state(), {});
  const std::string former = test::bytes_of(path);
  Snapshot broken = test::example_state(20);
  broken.grains.position[7].y() = std::nan("");
  expect_error<DataError>([&] { write_packing(path, broken, {}); },
                          path.string() + ": grain 7 (body_id 993): position is not finite");
  EXPECT_EQ(test::bytes_of(path), former);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST_F(Files, OutputThatCannotBeCreatedIsTold) {
  const Snapshot state = test::example_state();
  expect_error<CannotCreate>([&] { write_packing(folder.path(), state, {}); }, ": a directory");
  expect_error<CannotCreate>([&] { write_packing(folder / "none/file.h5", state, {}); }, "cannot be created");
  expect_error<CannotCreate>([&] { write_packing("", state, {}); }, "no output file named");
}

TEST_F(Files, FullDeviceIsAnIoError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  expect_error<IoError>([&] { write_packing("/dev/full", test::example_state(), {}); }, "/dev/full: writing failed");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(Files, LinkIsWrittenThrough) {
  const auto link = folder / "link.h5";
  write_packing(path, test::example_state(3), {});
  std::filesystem::create_symlink("file.h5", link);
  write_packing(link, test::example_state(5), {});
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_state(path).state.grains.size(), 5U);
}

/// Runs `act` in a child process whose standard input or output is this file; returns its exit status.
int in_child(int descriptor, const std::filesystem::path& file, const std::function<void()>& act) {
  const pid_t child = fork();
  if (child == 0) {
    const int opened = open(file.c_str(), descriptor == 0 ? O_RDONLY : O_WRONLY | O_CREAT, 0600);
    dup2(opened, descriptor);
    int status = 0;
    try {
      act();
    } catch (const Error& error) {
      status = static_cast<int>(error.status());
    }
    _exit(status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(Files, DashIsTheSameFileThroughAPipe) {
  const Snapshot state = test::example_state(500);
  write_packing(path, state, {});
  const auto copied = folder / "copied.h5";
  EXPECT_EQ(in_child(1, copied, [&] { write_packing("-", state, {}); }), 0);
  EXPECT_EQ(test::bytes_of(path), test::bytes_of(copied));
  EXPECT_EQ(in_child(0, copied, [&] { write_packing(folder / "back.h5", read_state("-").state, {}); }), 0);
  EXPECT_EQ(test::bytes_of(path), test::bytes_of(folder / "back.h5"));
  EXPECT_EQ(in_child(1, "/dev/full", [&] { write_packing("-", state, {}); }), static_cast<int>(Exit::io));
  EXPECT_EQ(in_child(0, "/dev/null", [&] { read_state("-"); }), static_cast<int>(Exit::bad_data));
}

TEST_F(Files, FramesOfARunMustBeAlike) {
  RunFile run = test::example_run();
  run.snapshots[2] = test::example_state(13);
  expect_error<DataError>([&] { write_run(path, run, {}); }, "state 2 differs from state 0 in its number of grains");
  run = test::example_run();
  std::swap(run.snapshots[0], run.snapshots[1]);
  expect_error<DataError>([&] { write_run(path, run, {}); }, "state 1 is of an earlier step than 0");
  run.snapshots.clear();
  expect_error<DataError>([&] { write_run(path, run, {}); }, "no state to write");
}

TEST_F(Files, ColumnsMustHaveNamesAndOneLength) {
  RunFile run = test::example_run();
  run.series.columns[2].name = "a/b";
  expect_error<DataError>([&] { write_run(path, run, {}); }, "\"a/b\" cannot name a column");
  run.series.columns[2].name = "time";
  expect_error<DataError>([&] { write_run(path, run, {}); }, "/series: has two columns named time");
  run.series.columns[2].name = "p";
  run.series.columns[2].values.pop_back();
  expect_error<DataError>([&] { write_run(path, run, {}); }, "/series/p has 3 values where step has 4");
}

// ---- Checks
// ----------------------------------------------------------------------------------------------------------

TEST(Check, TellsWhatIsWrongWithAState) {
  const auto wrong = [](const std::string& words, const std::function<void(Snapshot&)>& spoil) {
    Snapshot state = test::example_state(12, 3, true);
    check(state, "here");
    spoil(state);
    expect_error<DataError>([&] { check(state, "here"); }, "here: " + words);
  };
  wrong("arrays of grains have different lengths, 12 and 11", [](Snapshot& s) { s.grains.mass.pop_back(); });
  wrong("arrays of contacts have different lengths", [](Snapshot& s) { s.contacts.overlap.pop_back(); });
  wrong("arrays of planes have different lengths", [](Snapshot& s) { s.planes.normal.pop_back(); });
  wrong("the dimension is 4", [](Snapshot& s) { s.grains.dimension = 4; });
  wrong("holds no grains", [](Snapshot& s) { s.grains = {}; });
  wrong("time is not finite", [](Snapshot& s) { s.time = std::nan(""); });
  wrong("the cell vectors span no volume", [](Snapshot& s) { s.cell.matrix(2, 2) = 0; });
  wrong("the cell vectors span no volume, or are left-handed", [](Snapshot& s) { s.cell.matrix.col(0) *= -1; });
  wrong("the velocity gradient is not finite", [](Snapshot& s) { s.cell.velocity_gradient(0, 0) = std::nan(""); });
  wrong("grain 3 (body_id 997): radius is not positive", [](Snapshot& s) { s.grains.radius[3] = 0; });
  wrong("grain 3 (body_id 997): mass is not positive", [](Snapshot& s) { s.grains.mass[3] = -1; });
  wrong("grain 3 (body_id 997): lies more than 1e9 m from the origin",
        [](Snapshot& s) { s.grains.position[3].x() = 1e10; });
  wrong("grain 3 (body_id 997): orientation is no unit", [](Snapshot& s) { s.grains.orientation[3] *= 2; });
  wrong("grain 3 (body_id 997): material_id is negative", [](Snapshot& s) { s.grains.material_id[3] = -1; });
  wrong("grain 3 (body_id 997): velocity is not", [](Snapshot& s) { s.grains.velocity[3].x() = INFINITY; });
  wrong("the largest grain (0.5 m across) is not smaller than half the cell along axis x",
        [](Snapshot& s) { s.grains.radius[3] = 0.25; });
  wrong("contact 2 (grains 2 and 12): names a grain", [](Snapshot& s) { s.contacts.bodies[2][1] = 12; });
  wrong("contact 3 (grains 3 and -3): names a grain", [](Snapshot& s) { s.contacts.bodies[3][1] = -3; });
  wrong("contact 2 (grains 2 and 2): the first grain must", [](Snapshot& s) { s.contacts.bodies[2][1] = 2; });
  wrong("contact 5 (grains 1 and 6): is out of order", [](Snapshot& s) { s.contacts.bodies[5][0] = 1; });
  wrong("contact 5 (grains 5 and 6): normal is no unit", [](Snapshot& s) { s.contacts.normal[5] *= 1.01; });
  wrong("contact 5 (grains 5 and 6): force is not", [](Snapshot& s) { s.contacts.shear_force[5].z() = NAN; });
  wrong("contact 5 (grains 5 and 6): moment is not", [](Snapshot& s) { s.contacts.twisting_moment[5] = NAN; });
  wrong("plane 1: normal is no unit vector", [](Snapshot& s) { s.planes.normal[1] *= 2; });
}

TEST(Check, DisksStayInTheirPlane) {
  Snapshot state = test::example_state(5, 2);
  check(state, "disks");
  state.grains.position[2].z() = 1e-9;
  expect_error<DataError>([&] { check(state, "disks"); }, "leaves the plane of a 2D state");
  state = test::example_state(5, 2);
  state.cell.matrix(0, 2) = 0.1;
  expect_error<DataError>([&] { check(state, "disks"); }, "the cell of a 2D state leaves the plane");
}

}  // namespace
}  // namespace soilweave::io
