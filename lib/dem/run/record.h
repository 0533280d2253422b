// One row of a run's series: the quantities recorded at every station, with units and long names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/simulation.h"
#include "files/records.h"

namespace soilweave::dem {

/// Returns the columns that every run has, without rows. Energies are the terms of engine/energies.
io::Series empty_series();
/// Appends a row for the present state. `state`: its snapshot; `energies`: its energies; `stage`: number of the stage,
/// from 0.
void record(const Simulation& simulation, const io::Snapshot& state, const Energies& energies, int stage,
            io::Series& series);
/// Throws std::logic_error, which names the column, if a column does not have one value or two share a name.
/// Call it after the first row, before any loading could be lost.
void demand_distinct_columns(const io::Series& first_row);

}  // namespace soilweave::dem
