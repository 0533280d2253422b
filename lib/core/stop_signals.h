// Signals that ask a program to stop, held back and polled between steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace soilweave {

/// Holds back SIGTERM, SIGINT, SIGXCPU and SIGHUP in this thread and its later ones, without a handler.
/// Ignored signals stay ignored. Make it before the first parallel region.
class StopSignals {
 public:
  /// Begins to hold the signals back.
  StopSignals();
  /// Takes remaining signals off the queue.
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Returns the name of a signal that has come, or nullptr.
  const char* asked() const;

 private:
  /// Signals held back, and the mask before.
  sigset_t held_ = {}, before_ = {};
};

}  // namespace soilweave
