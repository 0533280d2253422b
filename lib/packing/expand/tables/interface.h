// Table of the friction between soil and a flat geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/interface.h"
#include "files/files.h"

namespace soilweave::packing::tables {

/// The table. Its members are those that run_tables.h demands.
struct Interface {
  static constexpr const char* name = "interface";
  static constexpr const char* long_name =
      "friction of soil on a flat geotextile in a shear box, one row per row of the series";
  static void demand(const io::RunFile& run, const std::string& where) { analysis::shear_box(run, where); }
  static io::Series make(const io::RunFile& run, const std::string& where) {
    return analysis::interface(run.series, analysis::shear_box(run, where));
  }
};

}  // namespace soilweave::packing::tables
