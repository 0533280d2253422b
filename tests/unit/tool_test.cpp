// The interface of a tool: arguments, help, manual page, errors and exit statuses.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cli/tool.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>

#include "core/error.h"

namespace soilweave {
namespace {

namespace fs = std::filesystem;

/// A tool with one option of each kind, which prints its values.
struct Sample {
  fs::path input, output, curve, side;
  std::vector<fs::path> more;
  double pressure = 1000;
  std::optional<double> friction;
  std::int64_t grains = 500;
  std::vector<std::string> assignments;
  std::string law = "linear", note;
  bool text = false, resume = false;
  std::function<void()> work;

  void options(tool::Table& t) {
    t.about("sample", "prints what it was given", "A tool for tests.");
    t.example("sample in.h5 -o out.h5", "the usual way");
    t.input(input, "INPUT", "what to read");
    t.inputs(more, "MORE", "what else to read");
    t.option(pressure, {"pressure", "Pa", 0, 1e9, true, "isotropic pressure", "no pressure, no stiffness"});
    t.option(friction, {"friction", "1", 0, 5, false, "friction coefficient", ""});
    t.option(grains, {"grains,n", "1", 2, 1e7, false, "number of grains", ""});
    t.option(assignments, "set", "KEY=VALUE", "replace a value");
    t.choice(law, "law", {"linear", "hertz-mindlin"}, "contact law");
    t.option(note, "note", "TEXT", "a remark");
    t.option(curve, "curve", "FILE", "grading curve");
    t.flag(text, "text", "as text");
    t.flag(resume, "resume", "go on");
    t.unrecorded("resume");
    t.seed();
    t.threads();
    t.output(output, "what to write");
    t.also_output(side, "side", "what else to write");
    t.refuse(
        {"friction", "grains"}, [this] { return law == "linear" && note == "plain"; }, "beside --note plain");
  }
  void validate() const {
    if (text && law != "linear") throw UsageError("--text: goes with --law linear only\n--law: linear is meant");
  }
  void run(const tool::Invocation& invocation) const {
    std::cout << invocation.command << "\nthreads " << invocation.threads << " curve " << curve.string() << " quiet "
              << invocation.quiet << "\n";
    if (work) work();
  }
};

struct Outcome {
  int status;
  std::string out, err;
};

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class Tool : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("tool_test_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    fs::current_path(folder_);
    std::ofstream("in.h5") << "x";
    std::ofstream("b.h5") << "x";
    unsetenv("OMP_NUM_THREADS");
  }
  void TearDown() override {
    fs::current_path("/");
    fs::remove_all(folder_);
  }

  /// Runs the tool in a child process, since it closes standard output.
  Outcome run(std::vector<std::string> arguments, const std::function<void()>& work = {},
              const char* standard_output = "out.txt") const {
    std::cout.flush();
    const pid_t child = fork();
    if (child == 0) {
      dup2(open(standard_output, O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
      dup2(open("err.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
      arguments.insert(arguments.begin(), "/some/where/sample");
      std::vector<char*> argv;
      for (std::string& argument : arguments) argv.push_back(argument.data());
      Sample tool;
      tool.work = work;
      const int status = tool::start(static_cast<int>(argv.size()), argv.data(),
                                     {[&](tool::Table& t) { tool.options(t); }, [&] { tool.validate(); },
                                      [&](const tool::Invocation& i) { tool.run(i); }});
      std::fflush(nullptr);
      // exit() would let a leak checker look for threads that a forked process does not have.
      _exit(status);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content("out.txt"), content("err.txt")};
  }

  fs::path folder_;
};

TEST_F(Tool, RecordsWhatChangesTheResultInTableOrderAndNothingElse) {
  const Outcome o = run({"--set", "a=1",   "-q",    "--threads=3", "--resume",      "--seed",     "7",          "in.h5",
                         "b.h5",  "-o",    "made",  "--law",       "hertz-mindlin", "--pressure", "100 kPa",    "-n",
                         "20",    "--set", "b=x y", "--curve",     "c.tsv",         "--force",    "--friction", "0"});
  EXPECT_EQ(o.err, "");
  EXPECT_EQ(o.status, 0);
  EXPECT_EQ(o.out,
            "sample --pressure 100000 --friction 0 --grains 20 --set a=1 --set 'b=x y' --law hertz-mindlin --seed 7\n"
            "threads 3 curve c.tsv quiet 1\n");
}

TEST_F(Tool, RefusesGivenOptionsThatHaveNoEffect) {
  Outcome o = run({"in.h5", "b.h5", "-o", "-", "--note", "plain", "-n", "500", "--friction", "1"});
  EXPECT_EQ(o.err,
            "sample: --friction has no effect beside --note plain: leave it out\n"
            "sample: --grains has no effect beside --note plain: leave it out\n");
  EXPECT_EQ(o.status, 64);
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--note", "plain", "--law", "hertz-mindlin", "-n", "500"}).err, "");
  // A value out of range is told first: the condition may depend on it.
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--note", "plain", "-n", "1"}).err.find("no effect"), std::string::npos);
}

TEST_F(Tool, RefusesToOverwriteOrResumeStandardOutput) {
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--force"}).err,
            "sample: --force has no effect without a file to write: leave it out\n");
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--resume"}).err,
            "sample: --resume has no effect beside -o -, for nothing is kept of standard output: leave it out\n");
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--side", "made", "--force"}).status, 0);
}

TEST_F(Tool, LeavesDefaultsOutOfTheRecord) {
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--pressure", "1 kPa"}).out, "sample\nthreads 1 curve  quiet 0\n");
}

TEST_F(Tool, TakesThreadsFromTheEnvironmentUnlessTold) {
  setenv("OMP_NUM_THREADS", "5,2", 1);
  EXPECT_NE(run({"in.h5", "b.h5", "-o", "-"}).out.find("threads 5"), std::string::npos);
  EXPECT_NE(run({"in.h5", "b.h5", "-o", "-", "--threads", "2"}).out.find("threads 2"), std::string::npos);
  setenv("OMP_NUM_THREADS", "-1", 1);
  EXPECT_NE(run({"in.h5", "b.h5", "-o", "-"}).out.find("threads 1"), std::string::npos);
}

TEST_F(Tool, TellsAllUsageMistakesAtOnceWithTheirRemedies) {
  const Outcome o = run({"in.h5", "b.h5", "-o", "-", "--pressure", "-5", "--friction", "x", "-n", "1.5", "--law",
                         "hertz", "--threads", "0", "--seed", "-1"});
  EXPECT_EQ(o.status, 64);
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(o.err,
            "sample: --pressure: -5 is out of range: must be between 0 and 1e9 Pa (no pressure, no stiffness)\n"
            "sample: --friction: 'x' is not a number; give a number from 0 to 5\n"
            "sample: --grains: '1.5' is not a whole number; give one from 2 to 1e7\n"
            "sample: --law: 'hertz' is not one of linear, hertz-mindlin; did you mean 'hertz-mindlin'?\n"
            "sample: --seed: '-1' is not a whole number from 0 to 2^64-1\n"
            "sample: --threads: 0 is out of range: must be from 1 to 1024 (more threads than that is a slip)\n");
}

TEST_F(Tool, NamesTheNearestOption) {
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--presure=3"}).err,
            "sample: unknown option '--presure'; did you mean '--pressure'?\n");
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--temperature", "3"}).err,
            "sample: unknown option '--temperature'; see 'sample --help'\n");
}

TEST_F(Tool, MissesWhatIsNotGiven) {
  const Outcome o = run({});
  EXPECT_EQ(o.status, 64);
  EXPECT_EQ(o.err,
            "sample: INPUT is missing: what to read\nsample: MORE is missing: what else to read\n"
            "sample: --output is missing: give '-o FILE', or '-o -' for standard output\n");
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--seed"}).err,
            "sample: --seed: a value is missing; see 'sample --help'\n");
  EXPECT_EQ(run({"-", "-", "-o", "-"}).err, "sample: '-' (standard input) can be read once only\n");
}

TEST_F(Tool, ValidationComesBeforeAnyFileIsLookedAt) {
  const Outcome o = run({"absent.h5", "b.h5", "-o", "-", "--text", "--law", "hertz-mindlin"});
  EXPECT_EQ(o.status, 64);
  EXPECT_EQ(o.err, "sample: --text: goes with --law linear only\nsample: --law: linear is meant\n");
}

TEST_F(Tool, MissingInputsAreToldBeforeAnyWork) {
  const Outcome o = run({"in.h5", "absent.h5", "-o", "-"});
  EXPECT_EQ(o.status, 66);
  EXPECT_EQ(o.err, "sample: absent.h5: no such file; check the name\n");
}

TEST_F(Tool, AnOutputThatCannotBeIsRefusedBeforeAnyWork) {
  const auto work = [] { std::ofstream("worked") << "x"; };
  Outcome o = run({"in.h5", "b.h5", "-o", "b.h5"}, work);
  EXPECT_EQ(o.status, 73);
  EXPECT_EQ(o.err, "sample: b.h5: exists; give --force to overwrite it\n");
  o = run({"in.h5", "b.h5", "-o", "nowhere/x.h5"}, work);
  EXPECT_EQ(o.status, 73);
  EXPECT_EQ(o.err, "sample: nowhere/x.h5: cannot be created: nowhere is not a directory; make it first\n");
  o = run({"in.h5", "b.h5", "-o", "in.h5/x.h5"}, work);
  EXPECT_EQ(o.status, 73);
  EXPECT_EQ(o.err, "sample: in.h5/x.h5: cannot be created: in.h5 is a file, not a directory; name another folder\n");
  o = run({"in.h5", "b.h5", "-o", "in.h5/y/x.h5"}, work);
  EXPECT_EQ(o.status, 73);
  EXPECT_EQ(o.err,
            "sample: in.h5/y/x.h5: cannot be created: in.h5/y cannot be reached: Not a directory; name another "
            "folder\n");
  o = run({"in.h5", "b.h5", "-o", ".", "--force"}, work);
  EXPECT_EQ(o.status, 73);
  EXPECT_EQ(o.err, "sample: .: is a directory; name a file to be written\n");
  EXPECT_FALSE(fs::exists("worked"));
  std::ofstream("old.h5") << "x";
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "old.h5", "--force"}, work).status, 0);
  EXPECT_TRUE(fs::exists("worked"));
}

TEST_F(Tool, NoOutputIsAnInputOrAnotherOutput) {
  const auto refused = [&](std::vector<std::string> arguments, const std::string& line) {
    arguments.insert(arguments.begin(), {"in.h5", "b.h5", "--force"});
    const Outcome o = run(arguments);
    EXPECT_EQ(o.status, 73);
    EXPECT_EQ(o.err, "sample: " + line + "\n");
  };
  fs::create_symlink("b.h5", "link.h5");
  fs::create_hard_link("b.h5", "hard.h5");
  std::ofstream("c.tsv") << "x";
  for (const std::string name : {"b.h5", "./b.h5", "link.h5", "hard.h5"})
    refused({"-o", name}, name + ": is read by this command and would be lost; name another file with --output");
  refused({"-o", "out.h5", "--side", "link.h5"},
          "link.h5: is read by this command and would be lost; name another file with --side");
  refused({"-o", "c.tsv", "--curve", "c.tsv"},
          "c.tsv: is read by this command and would be lost; name another file with --output");
  refused({"-o", "out.h5", "--side", "./out.h5"}, "./out.h5: is to be written by --output and --side; name two files");
  refused({"-o", "out.h5", "--side", "none/x"}, "none/x: cannot be created: none is not a directory; make it first");
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--side", "c.tsv"}).err,
            "sample: c.tsv: exists; give --force to overwrite it\n");
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "/dev/null", "--side", "/dev/null"}).status, 0);
}

TEST_F(Tool, WordsCannotSteerTheTerminal) {
  EXPECT_EQ(run({"in.h5", "a\nb\x1b[2J", "-o", "-"}).err, "sample: a\\nb\\x1b[2J: no such file; check the name\n");
  EXPECT_EQ(run({"in.h5", "b.h5", "-o", "-", "--law", "\x1b]0;x\x07\n"}).err,
            "sample: --law: '\\x1b]0;x\\x07\\n' is not one of linear, hertz-mindlin\n");
}

TEST_F(Tool, ALibraryThatEndsTheProgramIsNoTargetMissed) {
  const Outcome o = run({"in.h5", "b.h5", "-o", "-"}, [] { std::exit(1); });
  EXPECT_EQ(o.status, 70);
  EXPECT_NE(o.err.find("a library ended the program"), std::string::npos);
}

TEST_F(Tool, EveryErrorHasItsStatusAndOneLine) {
  const std::vector<std::string> usual{"in.h5", "b.h5", "-o", "-"};
  const auto status = [&](const std::function<void()>& work, const std::string& line) {
    const Outcome o = run(usual, work);
    EXPECT_EQ(o.err, line);
    return o.status;
  };
  EXPECT_EQ(status([] { throw TargetNotReached("e = 0.7"); }, "sample: e = 0.7\n"), 1);
  EXPECT_EQ(status([] { throw DataError("bad"); }, "sample: bad\n"), 65);
  EXPECT_EQ(status([] { throw PhysicsError("nan"); }, "sample: nan\n"), 70);
  EXPECT_EQ(status([] { throw IoError("disk"); }, "sample: disk\n"), 74);
  EXPECT_EQ(status([] { throw Stopped("later"); }, "sample: later\n"), 75);
  EXPECT_EQ(
      status([] { throw std::bad_alloc(); }, "sample: not enough memory; use fewer grains or a machine with more\n"),
      70);
  EXPECT_EQ(
      status([] { throw std::runtime_error("odd"); }, "sample: unexpected: odd; this is a defect, please report it\n"),
      70);
}

TEST_F(Tool, AFullDiskIsAnErrorAndAReaderThatLeavesIsNot) {
  const std::vector<std::string> usual{"in.h5", "b.h5", "-o", "-"};
  const Outcome full = run(usual, {}, "/dev/full");
  EXPECT_EQ(full.status, 74);
  EXPECT_EQ(full.err, "sample: standard output: No space left on device; not everything was written\n");
  const auto chatter = [] {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[1]);
    close(ends[0]);
    for (int i = 0; i < 100000; ++i) std::cout << "grain\n";
    throw IoError("standard output: broken");
  };
  const Outcome left = run(usual, chatter);
  EXPECT_EQ(left.status, 0);
  EXPECT_EQ(left.err, "");
}

TEST_F(Tool, HelpComesFromTheTable) {
  const Outcome o = run({"--help"});
  EXPECT_EQ(o.status, 0);
  EXPECT_TRUE(
      o.out.starts_with("sample: prints what it was given\n"
                        "Usage: sample [OPTION]... INPUT MORE... -o FILE\n"
                        "Example:\n  sample in.h5 -o out.h5\n      the usual way\n"))
      << o.out;
  EXPECT_NE(o.out.find("  --pressure Pa               isotropic pressure [1000]\n"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("  -n, --grains N              number of grains [500]\n"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("Exit status: 0 done, 1 target not reached, 64 wrong usage"), std::string::npos);
}

TEST_F(Tool, VersionNamesToolAndLicence) {
  const Outcome o = run({"--version"});
  EXPECT_EQ(o.status, 0);
  EXPECT_TRUE(o.out.starts_with("sample (soilweave) 0.1.0\nLicence GPL-3.0-or-later")) << o.out;
}

TEST_F(Tool, TheManualPageIsTheSameEachTimeAndHoldsRangesAndReasons) {
  const Outcome o = run({"--man"});
  EXPECT_EQ(o.status, 0);
  EXPECT_EQ(o.out, run({"--man"}).out);
  EXPECT_TRUE(o.out.starts_with(".TH sample 1 ")) << o.out;
  EXPECT_NE(o.out.find(".TP\n\\fB\\-\\-pressure\\fR \\fIPa\\fR\nIsotropic pressure.\n"
                       "Must be between 0 and 1e9 Pa (no pressure, no stiffness).\nDefault: 1000.\n"),
            std::string::npos)
      << o.out;
  EXPECT_NE(o.out.find(".SH EXIT STATUS"), std::string::npos);
}

TEST_F(Tool, CompletionOffersOptionsAndChoices) {
  const Outcome o = run({"--completion"});
  EXPECT_EQ(o.status, 0);
  EXPECT_NE(o.out.find("complete -o filenames -F _sample sample"), std::string::npos);
  EXPECT_NE(o.out.find("compgen -W \"linear hertz-mindlin\""), std::string::npos) << o.out;
}

}  // namespace
}  // namespace soilweave
