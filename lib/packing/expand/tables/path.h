// Table of the stress paths of a loaded bag.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/loading.h"
#include "files/files.h"
#include "packing/expand/loaded_bag.h"

namespace soilweave::packing::tables {

/// The table. Its members are those that run_tables.h demands.
struct Path {
  static constexpr const char* name = "path";
  static constexpr const char* long_name = "paths of stress of such a bag and its groups up to the first break";
  static void demand(const io::RunFile& run, const std::string& where) { loaded_bag(run, where); }
  static io::Series make(const io::RunFile& run, const std::string& where) {
    return analysis::stress_paths(run.series, run.snapshots, loaded_bag(run, where));
  }
};

}  // namespace soilweave::packing::tables
