// Cost of a run: counts, which are equal for equal runs, and seconds, which are not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/archive.h"
#include "dem/engine/simulation.h"

namespace soilweave::dem {

/// Cost of a run.
struct Cost {
  /// Number of grains.
  std::size_t grains = 0;
  /// Number of steps, and of contacts summed over the steps.
  std::int64_t steps = 0, contact_steps = 0;
  /// Number of steps in which stations waited for rest.
  std::int64_t waiting = 0;
  /// Number of waiting steps in which only the kinetic energy was above its limit.
  std::int64_t waiting_for_energy = 0;
  /// Seconds of stepping, and of making and writing rows and states.
  double stepping = 0, output = 0;
  /// Sampled times of the steps.
  StepTimes times;

  /// Returns the mean number of contacts per step.
  double contacts() const { return steps > 0 ? static_cast<double>(contact_steps) / static_cast<double>(steps) : 0; }
  /// Returns the time of a whole step per contact, ns.
  double per_contact() const { return contact_steps > 0 ? 1e9 * stepping / static_cast<double>(contact_steps) : 0; }
  /// Returns the share of a phase in the total time, from the sampled steps.
  double share(Phase phase) const;
  /// Returns the cost as one line.
  std::string line() const;
};

/// Measures the cost of work that may be interrupted and resumed.
class CostClock {
 public:
  /// Returns the cost over all sessions. The simulation counts its steps from 0.
  /// `keeping`: time spent on recording in this session, s.
  Cost cost(const Simulation& simulation, double keeping) const;
  /// Keeps the seconds of all sessions, or restores those of earlier sessions.
  void archive(const Simulation& simulation, double keeping, Archive& archive);

 private:
  /// Seconds of earlier sessions.
  double stepping_ = 0, output_ = 0;
  StepTimes times_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace soilweave::dem
