// Table of the stress paths of a loaded bag.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/loading.h"
#include "files/files.h"
#include "packing/expand/loaded_bag.h"

namespace soilweave::packing::tables {

/// The table, with the members of RunTable.
struct Path {
  /// Key of the table.
  static constexpr const char* name = "path";
  /// Description for --help.
  static constexpr const char* long_name = "paths of stress of such a bag and its groups up to the first break";
  /// Throws DataError naming `where` if the run has no such test.
  static void demand(const io::RunFile& run, const std::string& where) { loaded_bag(run, where); }
  /// Returns the table; throws what demand() throws.
  static io::Series make(const io::RunFile& run, const std::string& where) {
    return analysis::stress_paths(run.series, run.snapshots, loaded_bag(run, where));
  }
};

}  // namespace soilweave::packing::tables
