// Time of a step by phases, sampled in one step of seven.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace soilweave::dem {

/// Phases of a step.
enum class Phase : std::uint8_t { contacts, integration, neighbours };

/// Seconds of the sampled steps.
struct StepTimes {
  /// Seconds by phase.
  std::array<double, 3> seconds = {};
  /// Number of sampled steps.
  std::int64_t looked_at = 0;

  /// Returns the seconds of a phase.
  double of(Phase phase) const { return seconds[static_cast<std::size_t>(phase)]; }
};

/// Watch of one step. Laps count only in sampled steps.
class StepWatch {
 public:
  /// Begins the watch of a step.
  StepWatch(StepTimes& times, std::int64_t step) : times_(times), on_(step % interval == 0) {
    if (on_) ++times_.looked_at, last_ = Clock::now();
  }
  /// Returns whether this step is sampled.
  bool on() const { return on_; }
  /// Counts the time since the last lap for this phase.
  void lap(Phase phase) {
    if (!on_) return;
    const Clock::time_point now = Clock::now();
    times_.seconds[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  /// Moves s seconds from one phase to another.
  void shift(double s, Phase from, Phase to) {
    times_.seconds[static_cast<std::size_t>(from)] -= s;
    times_.seconds[static_cast<std::size_t>(to)] += s;
  }

 private:
  using Clock = std::chrono::steady_clock;
  /// Steps per sample. The interval of stiffness evaluations has no common divisor with it.
  static constexpr std::int64_t interval = 7;

  StepTimes& times_;
  Clock::time_point last_;
  bool on_;
};

/// Time of passes within a phase, summed over all threads.
class PassTime {
 public:
  /// Runs a pass and adds its time, if a timer is given.
  template <class Pass>
  static void count(PassTime* time, const Pass& pass) {
    using Clock = std::chrono::steady_clock;
    if (!time) return pass();
    const Clock::time_point began = Clock::now();
    pass();
    time->seconds_ += std::chrono::duration<double>(Clock::now() - began).count();
  }
  /// Returns the seconds of all passes so far.
  double seconds() const { return seconds_; }

 private:
  /// Seconds of all passes so far.
  std::atomic<double> seconds_ = 0;
};

}  // namespace soilweave::dem
