// Table of reinforced soil in a periodic cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/reinforced.h"
#include "files/files.h"

namespace soilweave::packing::tables {

/// The table. Its members are those that run_tables.h demands.
struct Reinforced {
  static constexpr const char* name = "reinforced";
  static constexpr const char* long_name = "reinforced soil in a periodic cell, one row per row of the series";
  static void demand(const io::RunFile& run, const std::string& where) { analysis::reinforced_cell(run, where); }
  static io::Series make(const io::RunFile& run, const std::string& where) {
    return analysis::reinforced(run.series, analysis::reinforced_cell(run, where));
  }
};

}  // namespace soilweave::packing::tables
