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
    /// Name of the stage.
    std::string name;
    /// Number of stations.
    std::size_t stations = 0;
    /// Estimated number of steps. The time to rest is known only after a run.
    double steps = 0;
    /// Number of steps that wait for rest.
    double waiting = 0;
    /// Range of the steps.
    double fewest = 0, most = 0;
    /// Whether the loading slows down with the unbalanced force.
    bool paced = false;
    /// Estimated and least number of steps of the longest station, not cut at equilibrium.steps.
    double longest = 0, least_longest = 0;
  };
  /// State before the first step, with the forces of the scenario's law.
  io::Snapshot begun;
  /// Forecast of each stage.
  std::vector<OfStage> stages;
  /// Stability limit and time step at the start, s.
  double stability_limit = 0, time_step = 0;
  /// Unbalanced force and largest overlap at the start, as ratios.
  double unbalanced_force = 0, largest_overlap = 0;
  /// Steps after which a station counts as unreachable.
  std::int64_t largest_station = 0;
  /// Number of recorded states.
  std::size_t states = 0;
  /// Size of the run's file and of the memory, bytes.
  double file_bytes = 0, memory_bytes = 0;
  /// Cost of the whole run.
  Cost cost;
  /// Range of the time, s.
  double least_time = 0, greatest_time = 0;

  /// Returns the lines for the user.
  std::string text() const;
};

/// The first steps of a run, timed to estimate the time of all others.
struct Trial {
  /// Number of steps tried.
  std::int64_t steps = 0;
  /// Time that they took, s.
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

/// Forecasts a run. `start`: as for run(). Throws the errors that the first steps of a run may throw.
Forecast forecast(const io::Snapshot& start, const Scenario& scenario);

}  // namespace soilweave::dem
