// Table of reinforced soil in a periodic cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/reinforced.h"
#include "files/files.h"

namespace soilweave::packing::tables {

/// The table, with the members of RunTable.
struct Reinforced {
  /// Key of the table.
  static constexpr const char* name = "reinforced";
  /// Description for --help.
  static constexpr const char* long_name = "reinforced soil in a periodic cell, one row per row of the series";
  /// Throws DataError naming `where` if the run has no such test.
  static void demand(const io::RunFile& run, const std::string& where) { analysis::reinforced_cell(run, where); }
  /// Returns the table; throws what demand() throws.
  static io::Series make(const io::RunFile& run, const std::string& where) {
    return analysis::reinforced(run.series, analysis::reinforced_cell(run, where));
  }
};

}  // namespace soilweave::packing::tables
