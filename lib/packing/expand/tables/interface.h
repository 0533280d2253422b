// Table of the friction between soil and a flat geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/interface.h"
#include "files/files.h"

namespace soilweave::packing::tables {

/// The table, with the members of RunTable.
struct Interface {
  /// Key of the table.
  static constexpr const char* name = "interface";
  /// Description for --help.
  static constexpr const char* long_name =
      "friction of soil on a flat geotextile in a shear box, one row per row of the series";
  /// Throws DataError naming `where` if the run has no such test.
  static void demand(const io::RunFile& run, const std::string& where) { analysis::shear_box(run, where); }
  /// Returns the table; throws what demand() throws.
  static io::Series make(const io::RunFile& run, const std::string& where) {
    return analysis::interface(run.series, analysis::shear_box(run, where));
  }
};

}  // namespace soilweave::packing::tables
