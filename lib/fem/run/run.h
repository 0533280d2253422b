// Carries out a two-scale scenario step by step and output by output.
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
  std::string cost;  // a line: steps, grain steps per second, seconds
};

/// Runs the whole duration. Every output is a row of the series and of the tables. With a folder to keep it in, the run
/// goes on from what is there and ends in the same bytes, on any number of threads and processes. All processes call
/// it; only the first one has a folder and the outcome. Throws PhysicsError when physics breaks, TargetNotReached if a
/// quasi-static state is not reached, Stopped after a signal.
Outcome run(const Scenario& scenario, const std::vector<io::Snapshot>& packings, const ProgressReport& report,
            const dem::Safekeeping& safekeeping, const io::History& history, const Ranks& ranks);

/// Returns a forecast: time steps of both scales, memory, file size and time, from a few tried steps.
std::string forecast(const Scenario& scenario, const std::vector<io::Snapshot>& packings);

}  // namespace soilweave::fem
