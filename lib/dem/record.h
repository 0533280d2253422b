// One row of a run's series: THE list of what is recorded at every station, with units and long names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/simulation.h"
#include "io/records.h"

namespace soilweave::dem {

/// Columns of a run's series, empty.
io::Series empty_series();
/// Appends the present state. stage: number of the stage, 0-based.
void record(const Simulation& simulation, int dimension, int stage, io::Series& series);

}  // namespace soilweave::dem
