// Reinforced soil in a periodic cell with fill, loaded along z: cell, soil, groups, fill and yarns side by side, from a
// run's series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::analysis {

/// The reinforced cell of a run, as far as its series does not describe it.
struct ReinforcedCell {
  std::optional<double> first_break;                // time of the first broken yarn, s
  std::vector<std::optional<double>> loading_rate;  // greatest strain rate along z by stage, 1/s; none under a stress
};

/// Returns the reinforced cell of a run. Throws DataError naming `where` and what the run lacks: a series, a cell
/// periodic along all axes, reinforced soil in it, or a column.
ReinforcedCell reinforced_cell(const io::RunFile& run, const std::string& where);

/// Returns the row from which strains count: the last row where the strains of the series restart at zero, else the
/// first.
std::size_t strain_origin(const io::Series& run);

/// Returns one row per row of the series; files/FORMAT.md lists the columns. Columns of fill and groups exist if the
/// series has them. Throws DataError naming a missing column.
io::Series reinforced(const io::Series& run, const ReinforcedCell& cell);

}  // namespace soilweave::analysis
