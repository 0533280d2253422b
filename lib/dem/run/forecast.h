// Forecast of a run from its input: steps, time, memory, file size. A few steps are tried and timed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "dem/run/cost.h"
#include "dem/run/scenario.h"

namespace soilweave::dem {

/// Forecast of a whole run, by stages and in total.
struct Forecast {
  /// Steps of one stage.
  struct OfStage {
    std::string name;
    std::size_t stations = 0;
    /// Estimate: the time to rest is known only afterwards.
    double steps = 0;
    /// Number of them that wait for rest.
    double waiting = 0;
    /// Range of the steps.
    double fewest = 0, most = 0;
    bool paced = false;  // true: the loading slows down with the unbalanced force
  };
  std::vector<OfStage> stages;
  double stability_limit = 0, time_step = 0;  // s, at the start
  double unbalanced_force = 0, largest_overlap = 0;
  std::size_t states = 0;  // recorded states
  double file_bytes = 0, memory_bytes = 0;
  Cost cost;
  double least_time = 0, greatest_time = 0;  // s, range of the time

  /// Returns the lines for the user.
  std::string text() const;
};

/// The first steps of a run, taken to know the time of all others.
struct Trial {
  std::int64_t steps = 0;
  double seconds = 0;
};
/// Calls step() two hundred times, but stops once `most` seconds have passed.
template <class Step>
Trial try_steps(double most, Step step) {
  using Clock = std::chrono::steady_clock;
  constexpr std::int64_t wanted = 200;  // they average over a few evaluations of the stiffness
  const auto start = Clock::now();
  Trial trial;
  while (trial.steps < wanted && trial.seconds < most) {
    step();
    ++trial.steps;
    trial.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  return trial;
}

/// start: as for run(). Throws what the first steps of a run throw.
Forecast forecast(const io::Snapshot& start, const Scenario& scenario);

}  // namespace soilweave::dem
