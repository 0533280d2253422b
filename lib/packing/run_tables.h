// The tables that a run gives as a whole, for what it loads: a bag between plates, reinforced soil in a cell, soil on
// a geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/files.h"

namespace soilweave::packing {

/// One such table.
struct RunTable {
  const char *name, *long_name;
  /// Throws DataError naming `where` and what the run lacks for this table.
  void (*demand)(const io::RunFile& run, const std::string& where);
  /// Returns the table; throws as demand does.
  io::Series (*make)(const io::RunFile& run, const std::string& where);

  /// Whether the run has all that the table needs.
  bool given_by(const io::RunFile& run) const;
};

/// All of them, in the order in which files have them.
const std::vector<RunTable>& run_tables();

}  // namespace soilweave::packing
