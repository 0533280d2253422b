// Reinforced soil in a periodic cell with fill around it, loaded along z: cell, soil, groups, fill and yarns side by
// side, from a run's series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/files.h"

namespace soilweave::analysis {

/// The reinforced cell of a run, as far as its series does not tell of it.
struct ReinforcedCell {
  std::optional<double> first_break;                // s, when the first yarn broke
  std::vector<std::optional<double>> loading_rate;  // 1/s, largest, along z in each stage; none under a stress
};

/// Returns the reinforced cell of a run. Throws DataError naming `where` and what the run lacks: a series, a cell that
/// is periodic along all axes, reinforced soil in it, or a column.
ReinforcedCell reinforced_cell(const io::RunFile& run, const std::string& where);

/// Row that strains count from: the last one at which the strains of the series begin at zero, else the first.
std::size_t strain_origin(const io::Series& run);

/// One row per row of the series; the columns are listed in io/FORMAT.md. Those of fill and groups are there where the
/// series has them. Throws DataError naming a column that the series lacks.
io::Series reinforced(const io::Series& run, const ReinforcedCell& cell);

}  // namespace soilweave::analysis
