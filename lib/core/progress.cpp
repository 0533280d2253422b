// Progress on standard error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/terminal.h"

namespace soilweave {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double terminal_interval = 0.1;  // s
constexpr double line_interval = 30;       // s
constexpr std::string_view clear_line = "\r\033[K";

std::string span_text(double seconds) {
  const long s = std::lround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
}

}  // namespace

Progress::Progress(std::string name, bool quiet)
    : name_(std::move(name)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(terminal_ ? start_ - std::chrono::hours(1) : start_) {}

Progress::~Progress() {
  if (shown_ && terminal_) tell(clear_line);
}

void Progress::update(double fraction, std::string_view detail) {
  if (quiet_) return;
  first_ = std::min(first_, fraction);
  const Clock::time_point now = Clock::now();
  if (Seconds(now - last_).count() < (terminal_ ? terminal_interval : line_interval)) return;
  last_ = now;
  const double elapsed = Seconds(now - start_).count();
  const double done = std::clamp(fraction, 0.0, 1.0), gone = done - first_;
  // Below a hundredth the remaining time is too uncertain to print.
  const std::string left = gone > 0.01 ? fmt::format(", {} left", span_text(elapsed * (1 - done) / gone)) : "";
  const std::string line =
      fmt::format("{} {:3.0f} %{}{}{}", name_, 100 * done, left, detail.empty() ? "" : ", ", detail);
  tell(fmt::format("{}{}{}", terminal_ ? clear_line : "", printable(line), terminal_ ? "" : "\n"));
  shown_ = true;
}

void Progress::note(std::string_view line) {
  if (quiet_) return;
  tell(fmt::format("{}{}\n", shown_ && terminal_ ? clear_line : "", printable(line)));
  shown_ = false;
}

}  // namespace soilweave
