// Table of the loading of a bag between two plates.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/loading.h"
#include "files/files.h"
#include "packing/expand/loaded_bag.h"

namespace soilweave::packing::tables {

/// The table, with the members of RunTable.
struct Loading {
  /// Key of the table.
  static constexpr const char* name = "loading";
  /// Description for --help.
  static constexpr const char* long_name = "a bag between two plates, one row per row of the series";
  /// Throws DataError naming `where` if the run has no such test.
  static void demand(const io::RunFile& run, const std::string& where) { loaded_bag(run, where); }
  /// Returns the table; throws what demand() throws.
  static io::Series make(const io::RunFile& run, const std::string& where) {
    return analysis::loading(run.series, loaded_bag(run, where));
  }
};

}  // namespace soilweave::packing::tables
