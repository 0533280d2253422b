// Tables of a whole run, one file each in tables/.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::packing {

/// One table.
struct RunTable {
  /// Key, and description for --help.
  const char *name, *long_name;
  /// Throws DataError naming `where` and the missing data.
  void (*demand)(const io::RunFile& run, const std::string& where);
  /// Returns the table; throws what demand() throws.
  io::Series (*make)(const io::RunFile& run, const std::string& where);

  /// Returns whether the run has all that the table needs.
  bool given_by(const io::RunFile& run) const;
};

/// Returns all tables, sorted by name.
const std::vector<RunTable>& run_tables();

}  // namespace soilweave::packing
