// Progress lines: sparse where nobody watches, none when quiet.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/progress.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <string>
#include <thread>

namespace soilweave {
namespace {

/// Standard error as a terminal for the life of the object; text() is what appeared there.
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
  /// What appeared, up to and with `last`.
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

// Begun half done: what is left is not guessed from work that others did.
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

}  // namespace
}  // namespace soilweave
