// Signals that ask a program to stop. They are held back and polled between steps, so that a step is finished and its
// state written first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace soilweave {

/// Holds back SIGTERM, SIGINT, SIGXCPU and SIGHUP, without a handler, in this thread and in those it starts later.
/// Signals that the caller of the program ignores stay ignored. Make it before the first parallel region.
class StopSignals {
 public:
  /// Begins to hold the signals back.
  StopSignals();
  /// Takes remaining signals off the queue: they were obeyed, or came after the work.
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
