// One row of a run's series: what is recorded at every station, with units and long names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/simulation.h"
#include "files/records.h"

namespace soilweave::dem {

/// Returns the columns that every run has, without rows. Energies are the terms of engine/energies.
io::Series empty_series();
/// Appends the present state. energies: the present ones; stage: number of the stage, from 0.
void record(const Simulation& simulation, const Energies& energies, int dimension, int stage, io::Series& series);
/// Throws std::logic_error naming the column unless the first row gave each column one value and all names differ.
/// Call it before the work, which a name taken twice would lose.
void demand_distinct_columns(const io::Series& first_row);

}  // namespace soilweave::dem
