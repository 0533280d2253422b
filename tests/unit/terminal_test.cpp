// Text cannot steer a terminal, and standard error may be gone.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <new>

#include "core/progress.h"
#include "core/threads.h"

namespace soilweave {
namespace {

/// Returns the exit status of a child process that does the work; -1 if a signal ended it.
int alone(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Terminal, WritesOutWhatATerminalWouldObey) {
  EXPECT_EQ(printable("plain µm ² 砂 \\x"), "plain µm ² 砂 \\x");
  EXPECT_EQ(printable("a\x1b[2J\x07\r\n\t\x7f"), "a\\x1b[2J\\x07\\r\\n\\t\\x7f");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("a\nb\tc\x1b", "\n\t"), "a\nb\tc\\x1b");
  // The text has a control of the second set, a change of direction, a mark of order, characters without width.
  EXPECT_EQ(printable("\u009b1m\u202eabc\u2066\u200b\ufeff"), "\\u{9b}1m\\u{202e}abc\\u{2066}\\u{200b}\\u{feff}");
  // The bytes are a lone one, a character cut short, an overlong one, half of a surrogate pair, one beyond the last.
  EXPECT_EQ(printable("\xff|\xc3|\xc0\xaf|\xed\xa0\x80|\xf4\x90\x80\x80"),
            "\\xff|\\xc3|\\xc0\\xaf|\\xed\\xa0\\x80|\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(printable(printable("\x1b")), printable("\x1b"));
}

TEST(Terminal, AStandardErrorThatIsGoneEndsNothing) {
  const auto talks = [] {
    Progress progress("run", false);
    for (int k = 0; k < 3; ++k) progress.note("a line"), tell("another\n");
    return 7;
  };
  EXPECT_EQ(alone([&] {
              close(STDERR_FILENO);
              return talks();
            }),
            7);
  EXPECT_EQ(alone([&] {
              dup2(open("/dev/full", O_WRONLY), STDERR_FILENO);
              return talks();
            }),
            7);
  EXPECT_EQ(alone([&] {
              int ends[2];
              if (pipe(ends) != 0) return 1;
              std::signal(SIGPIPE, SIG_IGN);
              dup2(ends[1], STDERR_FILENO), close(ends[0]), close(ends[1]);
              return talks();
            }),
            7);
}

TEST(Terminal, ClosedStandardStreamsKeepTheirNumbersAndStillFail) {
  EXPECT_EQ(alone([] {
              for (const int stream : {0, 1, 2}) close(stream);
              occupy_standard_streams();
              const int next = open("/dev/null", O_RDWR);
              char byte = 0;
              const bool fails = read(0, &byte, 1) < 0 && write(1, "x", 1) < 0 && write(2, "x", 1) < 0;
              // Numbers from 3 on may be open already, because a process inherits the files of its parent.
              return !fails ? 1 : next > STDERR_FILENO ? 0 : 2;
            }),
            0);
}

TEST(Threads, AreTriedBeforeTheyAreNeeded) {
  EXPECT_NO_THROW(demand_threads(1));
  EXPECT_NO_THROW(demand_threads(3));
}

}  // namespace
}  // namespace soilweave
