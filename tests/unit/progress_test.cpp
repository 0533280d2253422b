// Progress lines: sparse without a terminal, none when quiet.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/progress.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <thread>

namespace soilweave {
namespace {

/// Standard error as a terminal for the life of the object; text() returns its content.
class Terminal {
 public:
  Terminal() : kept_(dup(STDERR_FILENO)) {
    int line = -1;
    if (openpty(&master_, &line, nullptr, nullptr, nullptr) == 0) dup2(line, STDERR_FILENO);
    if (line >= 0) close(line);
  }
  ~Terminal() {
    dup2(kept_, STDERR_FILENO);
    close(kept_);
    close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  /// Returns the content up to and with `last`.
  std::string text(const std::string& last) const {
    std::string all;
    char c = 0;
    while (!all.ends_with(last) && read(master_, &c, 1) == 1) all += c;
    return all;
  }

 private:
  int kept_, master_ = -1;
};

TEST(Progress, IsSilentWhenQuiet) {
  testing::internal::CaptureStderr();
  {
    Progress progress("strain", true);
    progress.update(0.5, "step 1");
    progress.note("done");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Progress, WritesNotesAtOnceButNoLineInTheFirstSecondsWithoutATerminal) {
  testing::internal::CaptureStderr();
  {
    Progress progress("strain", false);
    for (int i = 0; i < 1000; ++i) progress.update(i / 1000.0, "step");
    progress.note("isotropic: done");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "isotropic: done\n");
}

// For work that begins half done, the time left must not count work that others did.
TEST(Progress, RewritesOneLineOnATerminalAtMostTenTimesASecond) {
  std::string shown;
  {
    const Terminal terminal;
    Progress progress("strain", false);
    for (int i = 0; i < 100; ++i) progress.update(0.5, "step 7");
    std::this_thread::sleep_for(std::chrono::milliseconds(110));
    progress.update(2.0, "step 8");
    progress.note("held");
    shown = terminal.text("\n");
  }
  EXPECT_EQ(shown,
            "\r\033[Kstrain  50 %, step 7"
            "\r\033[Kstrain 100 %, 0 s left, step 8"
            "\r\033[Kheld\r\n");
}

// Expects the time left at an even pace: begun at `first`, with `done` of all, it is (1 - done)/(done - first) times
// the elapsed time.
void expect_time_left(double first, double done, int milliseconds) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
  std::string shown;
  double least = 0, most = 0;
  {
    const Terminal terminal;
    const Clock::time_point early = Clock::now();
    Progress progress("strain", false);
    progress.update(first);
    const Clock::time_point late = Clock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    least = seconds(Clock::now() - late);
    progress.update(done);
    most = seconds(Clock::now() - early);
    progress.note("held");
    shown = terminal.text("\n");
  }
  std::size_t at = shown.rfind(" %, ");
  ASSERT_NE(at, std::string::npos) << shown;
  int minutes = 0, left = 0;
  const char* const text = shown.c_str() + at + 4;
  if (std::sscanf(text, "%d min %d s left", &minutes, &left) != 2) {
    minutes = 0;
    ASSERT_EQ(std::sscanf(text, "%d s left", &left), 1) << shown;
  }
  EXPECT_LT(left, 60);
  const double ratio = (1 - done) / (done - first);
  EXPECT_GE(60 * minutes + left, std::lround(least * ratio)) << shown;
  EXPECT_LE(60 * minutes + left, std::lround(most * ratio)) << shown;
}

TEST(Progress, TellsTheTimeLeftFromWhatItSawDone) {
  expect_time_left(0, 0.1, 350);
  expect_time_left(0.5, 0.6, 600);
  expect_time_left(0.1, 0.111, 1000);  // 81 times as long: a minute and some seconds
}

}  // namespace
}  // namespace soilweave
