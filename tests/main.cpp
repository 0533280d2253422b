// Runs the tests of a program. A test that hangs is stopped and named; skipped tests are noted with their reasons.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

// End of the message about a hanging test, made beforehand because a signal handler may neither allocate nor format.
std::string too_long;

extern "C" void stop(int) {
  const auto written = write(STDOUT_FILENO, too_long.data(), too_long.size());
  _exit(written < 0 ? 2 : 1);
}

/// Stops a test after SOILWEAVE_TEST_LIMIT seconds (600 by default), and appends a line for each skipped test to the
/// file SOILWEAVE_SKIPPED: program, test and reason, with tabs between them.
class Watch : public testing::EmptyTestEventListener {
 public:
  explicit Watch(std::string program) : program_(std::move(program)) {
    if (const char* limit = std::getenv("SOILWEAVE_TEST_LIMIT"); limit && std::atoi(limit) > 0)
      limit_ = std::atoi(limit);
    if (const char* path = std::getenv("SOILWEAVE_SKIPPED")) skipped_ = path;
    std::signal(SIGALRM, stop);
  }

 private:
  void OnTestStart(const testing::TestInfo& test) override {
    too_long = "[  FAILED  ] " + name(test) + ": stopped, for it takes more than " + std::to_string(limit_) + " s\n";
    alarm(static_cast<unsigned>(limit_));
  }
  void OnTestEnd(const testing::TestInfo& test) override {
    alarm(0);
    if (skipped_.empty() || !test.result()->Skipped()) return;
    std::string reason = "no reason given";
    for (int i = 0; i < test.result()->total_part_count(); ++i)
      if (const auto& part = test.result()->GetTestPartResult(i); part.skipped() && *part.message() != 0)
        reason = part.message();
    std::ofstream(skipped_, std::ios::app) << program_ + '\t' + name(test) + '\t' + reason + '\n';
  }
  static std::string name(const testing::TestInfo& test) {
    return std::string(test.test_suite_name()) + "." + test.name();
  }

  std::string program_, skipped_;
  int limit_ = 600;
};

}  // namespace

// Hides two leaks of other libraries: memory that the OpenMP runtime keeps for its threads, and memory that HDF5 loses
// when it reads a damaged file. It also hides leaks within a function that HDF5 calls (store_read.cpp has one).
extern "C" const char* __lsan_default_suppressions() { return "leak:libomp.so\nleak:libhdf5\n"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(
      new Watch(std::filesystem::path(argc > 0 ? argv[0] : "tests").filename()));
  return RUN_ALL_TESTS();
}
