// Signals that ask a program to stop. They are blocked, and polled between steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace soilweave {

/// Blocks SIGTERM, SIGINT, SIGXCPU and SIGHUP in this thread and in threads that it starts later. Installs no handler.
/// Ignored signals stay ignored. Construct it before the first parallel region.
class StopSignals {
 public:
  /// Blocks the signals.
  StopSignals();
  /// Discards pending signals and restores the former mask.
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Returns the name of a pending signal, or nullptr.
  const char* asked() const;

 private:
  /// Blocked signals, and the signal mask before.
  sigset_t held_ = {}, before_ = {};
};

}  // namespace soilweave
