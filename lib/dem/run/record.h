// One row of a run's series: the only list of what is recorded at every station, with units and long names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/simulation.h"
#include "files/records.h"

namespace soilweave::dem {

/// Returns the columns of a run's series, without rows.
io::Series empty_series();
/// Appends the present state. stage: number of the stage, from 0.
void record(const Simulation& simulation, int dimension, int stage, io::Series& series);

}  // namespace soilweave::dem
