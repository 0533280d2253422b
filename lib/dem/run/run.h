// Carries out a scenario stage by stage and station by station, and records it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/progress.h"
#include "dem/run/cost.h"
#include "dem/run/keeper.h"
#include "dem/run/prepare.h"
#include "dem/run/scenario.h"
#include "files/files.h"

namespace soilweave::dem {

/// Appends values of a recorded state to further columns of the series, the same columns each time.
using Observe = std::function<void(const io::Snapshot& state, io::Series& series)>;

/// Result of a run.
struct Outcome {
  /// Series, snapshots and resolved scenario.
  io::RunFile file;
  /// Cost over all sessions.
  Cost cost;
};

/// Throws DataError for a stage that moves facing planes closer together than grains between them allow
/// (plate_ways.h). `state`: a prepared state (prepare.h).
void demand_apart(const io::Snapshot& state, const Scenario& scenario);

/// Runs all stages. The series has one row at the start and one per station.
/// With a folder in `safekeeping`, the run continues from the last checkpoint there, and ends in the same bytes.
/// Throws TargetNotReached if a station cannot be settled, PhysicsError if physics breaks, Stopped after a signal.
Outcome run(const io::Snapshot& start, const Scenario& scenario, const ProgressReport& report,
            const Safekeeping& safekeeping = {}, const Observe& observe = {});

}  // namespace soilweave::dem
