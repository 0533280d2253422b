// Reinforced soil with fill in a periodic cell, loaded along z.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::analysis {

/// A reinforced cell, beyond the run's series.
struct ReinforcedCell {
  /// Time of the first broken yarn, s.
  std::optional<double> first_break;
  /// Greatest strain rate along z by stage, 1/s; empty for a stage under a given stress.
  std::vector<std::optional<double>> loading_rate;
};

/// Returns the reinforced cell of a run. Throws DataError naming `where` unless the run has a series with all columns,
/// and reinforced soil in a fully periodic cell.
ReinforcedCell reinforced_cell(const io::RunFile& run, const std::string& where);

/// Returns the last row where strains restart at zero; the first row if there is none.
std::size_t strain_origin(const io::Series& run);

/// Returns one row per row of the series (columns: files/FORMAT.md), with fill and groups if the series has them.
/// Throws DataError naming a missing column.
io::Series reinforced(const io::Series& run, const ReinforcedCell& cell);

}  // namespace soilweave::analysis
