// Tables of a whole run, according to what it loads: a bag between plates, reinforced soil in a cell, soil on a
// geotextile. A new table is one file in tables/.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::packing {

/// One such table.
struct RunTable {
  const char *name, *long_name;
  /// Throws DataError naming `where` and what the run lacks for this table.
  void (*demand)(const io::RunFile& run, const std::string& where);
  /// Returns the table; throws what demand() throws.
  io::Series (*make)(const io::RunFile& run, const std::string& where);

  /// Returns whether the run has all that the table needs.
  bool given_by(const io::RunFile& run) const;
};

/// Returns all tables, sorted by name.
const std::vector<RunTable>& run_tables();

}  // namespace soilweave::packing
