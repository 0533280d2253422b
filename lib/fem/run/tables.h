// Tables of a two-scale run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/tensor.h"
#include "files/files.h"

namespace soilweave::fem {

/// Returns the table `name` of the run in the file `where`. Throws UsageError that lists its tables.
io::Series table(const io::MultiscaleFile& file, const std::string& name, const std::string& where);

/// Returns the global response (thesis Fig. 6.2), one row per output:
/// - step, time (s), displacement of the chain's ends (m);
/// - mean traction on each boundary over its present length (Pa), from nodal stresses (force_x_ and force_y_ of the
/// series);
/// - interface_friction: shear over normal force, positive against a pull at the chain's end, NaN without contact;
/// - the energy balance (J per metre).
io::Series loading(const io::MultiscaleFile& file);

/// Returns the rows of states: all, first, last or a number from 0 (io::chosen_states). Throws UsageError for a missing
/// state or column `step`.
io::Series of_state(const io::Series& table, const std::string& which, const std::string& name);

/// Returns the rows of the point or node nearest to `place` (m) in the first state; the first of equally near ones.
/// name: "points" or "nodes". Throws UsageError for another table, and outside the box of the nodes.
io::Series near(const io::MultiscaleFile& file, const std::string& name, const Vec2& place);

}  // namespace soilweave::fem
