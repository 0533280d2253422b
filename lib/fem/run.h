// A scenario of two scales carried out: step after step, output after output.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "dem/keeper.h"
#include "fem/scenario.h"
#include "io/files.h"

namespace soilweave::fem {

/// Called now and then: fraction done (0 to 1) and a line about the moment.
using Report = std::function<void(double fraction, const std::string& detail)>;

struct Outcome {
  io::MultiscaleFile file;
  std::string price;  // a line: steps, grain steps a second, seconds
};

/// Runs the whole duration; every output is a row of the series and of the tables. With a folder to keep it in, the run
/// goes on from what is there, and ends in the same file, bit by bit, on any number of threads and processes. All
/// processes call it; the first one alone has a folder, and the outcome. Throws PhysicsError
/// when physics breaks, TargetNotReached when a quasi-static state is not, Stopped after a signal.
Outcome run(const Scenario& scenario, const std::vector<io::Snapshot>& packings, const Report& report,
            const dem::Safekeeping& safekeeping, const io::History& history, const Ranks& ranks);

/// What a run will take: time steps of both scales, memory, file, time, from a few steps tried.
std::string forecast(const Scenario& scenario, const std::vector<io::Snapshot>& packings);

}  // namespace soilweave::fem
