// Signals that ask a program to come to an end: held back while it lives, looked at between steps, so that a step is
// finished and its state written before the program obeys.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace soilweave {

/// Holds back SIGTERM, SIGINT, SIGXCPU and SIGHUP in this thread and those it starts later, without a handler; what the
/// caller of the program ignores stays ignored. Make it before the first parallel region.
class StopSignals {
 public:
  StopSignals();
  /// Takes what has come off the queue: it was obeyed, or came when all was done.
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The name of a signal that has come, nullptr without.
  const char* asked() const;

 private:
  sigset_t held_ = {}, before_ = {};
};

}  // namespace soilweave
