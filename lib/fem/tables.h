// Tables that are asked of a run of two scales: its global response, the history of a place, the rows of one state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/tensor.h"
#include "io/files.h"

namespace soilweave::fem {

/// Returns a table of the run in the file `where` by its name. Throws UsageError listing the tables that it has.
io::Series table(const io::MultiscaleFile& file, const std::string& name, const std::string& where);

/// Returns the global response (thesis Fig. 6.2), a row an output: step, time (s), way of the chain's ends (m), mean
/// traction on the soil of each boundary over its present length (Pa; of the nodal stresses, force_x_ and force_y_ of
/// the series), `interface_friction` (shear over normal force between soil and chain, positive where it resists a pull
/// at the chain's end; NaN where they do not touch), and the energy balance (J per metre).
io::Series loading(const io::MultiscaleFile& file);

/// Returns the rows of the states that `which` names: all, first, last or a number from 0 (analysis::chosen_states).
/// Throws UsageError where there is no such state, or the table has no column `step`.
io::Series of_state(const io::Series& table, const std::string& which, const std::string& name);

/// Returns the rows of the one point or node that was nearest to `place` (m) in the first state; of equally near ones
/// the first. name: "points" or "nodes". Throws UsageError for another table, and where the place lies outside of the
/// box around the nodes of the first state.
io::Series near(const io::MultiscaleFile& file, const std::string& name, const Vec2& place);

}  // namespace soilweave::fem
