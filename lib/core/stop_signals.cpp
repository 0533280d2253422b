// Blocks signals and polls them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stop_signals.h"

#include <array>
#include <ctime>

namespace soilweave {
namespace {

struct Named {
  int number;
  const char* name;
};
constexpr std::array<Named, 4> ends = {
    {{SIGTERM, "SIGTERM"}, {SIGINT, "SIGINT"}, {SIGXCPU, "SIGXCPU"}, {SIGHUP, "SIGHUP"}}};

}  // namespace

StopSignals::StopSignals() {
  sigemptyset(&held_);
  for (const Named& signal : ends) {
    // An ignored signal (nohup, a shell's background job) must not be blocked, because it would then be queued.
    struct sigaction present = {};
    if (sigaction(signal.number, nullptr, &present) == 0 && present.sa_handler == SIG_IGN) continue;
    sigaddset(&held_, signal.number);
  }
  pthread_sigmask(SIG_BLOCK, &held_, &before_);
}

StopSignals::~StopSignals() {
  const timespec at_once = {};
  while (sigtimedwait(&held_, nullptr, &at_once) > 0) continue;
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

const char* StopSignals::asked() const {
  sigset_t pending;
  sigemptyset(&pending);
  sigpending(&pending);
  for (const Named& signal : ends)
    if (sigismember(&held_, signal.number) == 1 && sigismember(&pending, signal.number) == 1) return signal.name;
  return nullptr;
}

}  // namespace soilweave
