// Table of the loading of a bag between two plates.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/loading.h"
#include "files/files.h"
#include "packing/expand/loaded_bag.h"

namespace soilweave::packing::tables {

/// The table. Its members are those that run_tables.h demands.
struct Loading {
  static constexpr const char* name = "loading";
  static constexpr const char* long_name = "a bag between two plates, one row per row of the series";
  static void demand(const io::RunFile& run, const std::string& where) { loaded_bag(run, where); }
  static io::Series make(const io::RunFile& run, const std::string& where) {
    return analysis::loading(run.series, loaded_bag(run, where));
  }
};

}  // namespace soilweave::packing::tables
