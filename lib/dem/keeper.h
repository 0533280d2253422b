// When a run under way is written down: at intervals of the clock, and when a signal asks for its end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <new>

#include "core/error.h"
#include "core/stop_signals.h"
#include "io/part.h"

namespace soilweave::dem {

/// Steps between two reports, and between two looks at whether what is waited for has come to rest.
inline constexpr std::int64_t report_interval = 512, look_interval = 16;

/// Where and when a run is kept.
struct Safekeeping {
  io::Part* part = nullptr;              // nullptr: nowhere; a signal then ends the program as it always does
  double interval = 300;                 // s of the clock between checkpoints; 0: only recorded states
  const StopSignals* signals = nullptr;  // nullptr: none are looked for
};

class Keeper {
 public:
  Keeper(const Safekeeping& how, std::size_t grains);

  bool keeps() const { return how_.part != nullptr; }
  io::Part& part() const { return *how_.part; }
  /// To be called after every step: takes the moment by make() where it is time. Throws Stopped after a signal.
  template <class Make>
  void after_step(const Make& make) {
    if (!keeps() || ++steps_ % look_interval_ != 0) return;
    const char* signal = how_.signals ? how_.signals->asked() : nullptr;
    if (!signal && Clock::now() < due_) return;
    keep(make(), false);
    if (signal) stop(signal);
  }
  void keep(io::Moment moment, bool recorded);
  /// s, spent in keeping so far.
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  [[noreturn]] void stop(const char* signal) const;

  Safekeeping how_;
  std::int64_t steps_ = 0, look_interval_;
  Clock::time_point due_;
  double seconds_ = 0;
};

/// work.run(). Where the work is kept, an error says what is whole and how to go on, and a guard leaves
/// work.snapshot() to be looked at; so does a target that is not reached, if it is to be shown.
template <bool show_unreached, class Work>
auto carry_out(Work& work, const io::Part* part) {
  if (!part) return work.run();
  try {
    return work.run();
  } catch (const PhysicsError& error) {
    throw part->stopped(error, work.snapshot());
  } catch (const TargetNotReached& error) {
    if (!show_unreached) throw;
    throw part->stopped(error, work.snapshot());
  } catch (const Error& error) {
    throw part->explained(error);
  } catch (const std::bad_alloc&) {
    throw part->explained(Error(Exit::internal, "not enough memory; use fewer grains or a machine with more"));
  }
}

}  // namespace soilweave::dem
