// Writes checkpoints of an unfinished run: at intervals of the clock, and when a signal asks for its end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <new>

#include "core/error.h"
#include "core/stop_signals.h"
#include "files/part.h"

namespace soilweave::dem {

/// Steps between two reports, and between two checks whether the grains are at rest.
inline constexpr std::int64_t report_interval = 512, look_interval = 16;

/// Place and times of checkpoints.
struct Safekeeping {
  /// Folder of checkpoints; nullptr: none, and a signal ends the program as usual.
  io::Part* part = nullptr;
  /// Seconds between checkpoints; 0: recorded states only.
  double interval = 300;
  /// Signals that stop the run; nullptr: the keeper checks none.
  const StopSignals* signals = nullptr;
};

/// Keeper of checkpoints for one run.
class Keeper {
 public:
  /// Prepares the checkpoints of a run. `grains`: number of grains.
  Keeper(const Safekeeping& how, std::size_t grains);

  /// Returns whether checkpoints are written at all.
  bool keeps() const { return how_.part != nullptr; }
  /// Returns the folder; only if keeps().
  io::Part& part() const { return *how_.part; }
  /// Writes the checkpoint that make() returns when it is due. Throws Stopped after a signal.
  /// Call it after every step.
  template <class Make>
  void after_step(const Make& make) {
    if (!keeps() || ++steps_ % look_interval_ != 0) return;
    const char* signal = how_.signals ? how_.signals->asked() : nullptr;
    if (!signal && Clock::now() < due_) return;
    keep(make, false);
    if (signal) stop(signal);
  }
  /// Makes and writes a checkpoint, and sets the time of the next one.
  template <class Make>
  void keep(const Make& make, bool recorded) {
    set_next(timed([&] { part().keep(make(), recorded); }));
  }
  /// Does work that only records the run. Returns its time, which counts in seconds().
  template <class Work>
  double timed(const Work& work) {
    const Clock::time_point start = Clock::now();
    work();
    const double took = std::chrono::duration<double>(Clock::now() - start).count();
    seconds_ += took;
    return took;
  }
  /// Returns the time spent on recording so far, checkpoints included, s.
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  /// Sets the time of the next checkpoint after one that took `took` seconds.
  void set_next(double took);
  /// Throws Stopped.
  [[noreturn]] void stop(const char* signal) const;

  Safekeeping how_;
  /// Number of steps so far, and number of steps between two checks of the clock.
  std::int64_t steps_ = 0, look_interval_;
  /// Time of the next checkpoint.
  Clock::time_point due_;
  /// Time spent on recording, s.
  double seconds_ = 0;
};

/// Calls work.run(). If there is a folder `part`, errors also tell which states are complete and how to resume.
/// After broken physics work.left() is saved: a state, or a function that writes a file.
/// With show_unreached, it is also saved after an unreached target.
template <bool show_unreached, class Work>
auto carry_out(Work& work, const io::Part* part) {
  if (!part) return work.run();
  try {
    return work.run();
  } catch (const PhysicsError& error) {
    throw part->stopped(error, work.left());
  } catch (const TargetNotReached& error) {
    if (!show_unreached) throw;
    throw part->stopped(error, work.left());
  } catch (const Error& error) {
    throw part->explained(error);
  } catch (const std::bad_alloc&) {
    throw part->explained(Error(Exit::internal, "not enough memory; use fewer grains or a machine with more"));
  }
}

}  // namespace soilweave::dem
