// Runs a two-scale scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/progress.h"
#include "dem/run/keeper.h"
#include "fem/run/scenario.h"
#include "files/files.h"

namespace soilweave::fem {

/// Result of a run.
struct Outcome {
  io::MultiscaleFile file;
  /// Steps, grain steps per second, and seconds, in one line.
  std::string cost;
};

/// Runs the whole duration, with a row of the series per output. A safekeeping folder lets the run go on later, to the
/// same bytes, on any number of threads and processes. All processes call it; only the first has folder and outcome.
/// doubts: receives doubts about packings, loads and duration before the first step, and about rest at the end. report:
/// also called once before the first step. Throws PhysicsError, TargetNotReached if no quasi-static state is reached,
/// Stopped after a signal.
Outcome run(const Scenario& scenario, const std::vector<io::Snapshot>& packings, const ProgressReport& report,
            const dem::Safekeeping& safekeeping, const io::History& history, const Ranks& ranks, Doubts& doubts);

/// Returns extent, time steps, memory, file size and time, forecast from a few steps. doubts: receives what a run
/// doubts before its first step.
std::string forecast(const Scenario& scenario, const std::vector<io::Snapshot>& packings, Doubts& doubts);

}  // namespace soilweave::fem
