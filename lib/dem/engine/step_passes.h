// Passes over the grains of a chunk, around the sweep of their pairs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/motion.h"
#include "dem/engine/step_times.h"
#include "dem/sweep/contact_sweep.h"

namespace soilweave::dem {

/// Moves the grains of a chunk before its sweep, unless they have moved already, and collects their loads after it.
class StepPasses final : public AroundChunk {
 public:
  /// `time`: accumulates the time of the passes, if given.
  StepPasses(bool moving, const Contacts& contacts, Motion& motion, Bodies& bodies, PassTime* time = nullptr)
      : moving_(moving), contacts_(contacts), motion_(motion), bodies_(bodies), time_(time) {}

  /// Returns whether grains move within the sweep.
  bool moving() const { return moving_; }
  void before(std::size_t chunk) override {
    if (moving_) PassTime::count(time_, [&] { motion_.advance(chunk, bodies_); });
  }
  void after(std::size_t chunk) override {
    PassTime::count(time_, [&] { motion_.collect(chunk, contacts_, bodies_); });
  }

 private:
  bool moving_;
  const Contacts& contacts_;
  Motion& motion_;
  Bodies& bodies_;
  PassTime* time_;
};

}  // namespace soilweave::dem
