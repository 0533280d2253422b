// Doubts: each said once, kept in the file that a run writes, absent from files without any.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/doubts.h"

#include <gtest/gtest.h>

#include "io/files.h"
#include "support/states.h"

namespace soilweave {
namespace {

const Doubt many_rattlers{"rattlers", "43 % of the grains bear nothing, over 15 %"};

io::History made_by(const std::string& tool) {
  tool::Invocation invocation;
  invocation.tool = tool, invocation.version = "1.0.0", invocation.command = tool;
  return io::extend({}, invocation);
}

TEST(Doubts, are_said_once_each_and_kept_in_order) {
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

TEST(Doubts, of_a_silent_process_are_kept_alone) {
  testing::internal::CaptureStderr();
  Doubts doubts;
  doubts.add(many_rattlers);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(doubts.all().size(), 1U);
}

TEST(Doubts, lie_in_the_record_of_the_run_that_wrote_the_file) {
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

TEST(Doubts, of_an_input_stay_in_its_record) {
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

}  // namespace
}  // namespace soilweave
