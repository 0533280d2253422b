// Where the time of a step goes, looked at in one step of seven: a clock read costs as much as a contact or two.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace soilweave::dem {

enum class Phase : std::uint8_t { contacts, integration, neighbours };

/// Seconds of the steps that were looked at.
struct StepTimes {
  std::array<double, 3> seconds = {};
  std::int64_t looked_at = 0;  // steps

  double of(Phase phase) const { return seconds[static_cast<std::size_t>(phase)]; }
};

/// Lives for one step; laps count only in a step that is looked at.
class StepWatch {
 public:
  StepWatch(StepTimes& times, std::int64_t step) : times_(times), on_(step % interval == 0) {
    if (on_) ++times_.looked_at, last_ = Clock::now();
  }
  bool on() const { return on_; }
  /// The time since the last lap was this phase's.
  void lap(Phase phase) {
    if (!on_) return;
    const Clock::time_point now = Clock::now();
    times_.seconds[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  /// Of the laps of one phase, s were another one's.
  void shift(double s, Phase from, Phase to) {
    times_.seconds[static_cast<std::size_t>(from)] -= s;
    times_.seconds[static_cast<std::size_t>(to)] += s;
  }

 private:
  using Clock = std::chrono::steady_clock;
  // Without a common divisor with the interval at which the engine looks at the stiffness.
  static constexpr std::int64_t interval = 7;

  StepTimes& times_;
  Clock::time_point last_;
  bool on_;
};

/// What passes within a phase take, by all threads.
class PassTime {
 public:
  /// Does it, and counts its time where one is given.
  template <class Pass>
  static void count(PassTime* time, const Pass& pass) {
    using Clock = std::chrono::steady_clock;
    if (!time) return pass();
    const Clock::time_point began = Clock::now();
    pass();
    time->seconds_ += std::chrono::duration<double>(Clock::now() - began).count();
  }
  double seconds() const { return seconds_; }

 private:
  std::atomic<double> seconds_ = 0;
};

}  // namespace soilweave::dem
