// A table of a run from outside the library: one row per state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "files/files.h"

namespace soilweave::packing::tables {

/// The table. It has the members that run_tables.h requires.
struct ToyTable {
  static constexpr const char* name = "toy-table";
  static constexpr const char* long_name = "grains of each state";
  static void demand(const io::RunFile&, const std::string&) {}
  static io::Series make(const io::RunFile& run, const std::string&) {
    io::Column grains{"toy_grains", "1", "number of grains", {}};
    for (const io::Snapshot& state : run.snapshots) grains.values.push_back(static_cast<double>(state.grains.size()));
    return {{std::move(grains)}};
  }
};

}  // namespace soilweave::packing::tables
