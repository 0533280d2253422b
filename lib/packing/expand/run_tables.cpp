// Tables of a whole run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/run_tables.h"

#include "analysis/tables/interface.h"
#include "analysis/tables/reinforced.h"
#include "core/error.h"
#include "packing/expand/loaded_bag.h"

namespace soilweave::packing {
namespace {

void demand_bag(const io::RunFile& run, const std::string& where) { loaded_bag(run, where); }

}  // namespace

bool RunTable::given_by(const io::RunFile& run) const {
  try {
    demand(run, "");
    return true;
  } catch (const DataError&) {
    return false;
  }
}

const std::vector<RunTable>& run_tables() {
  static const std::vector<RunTable> all = {
      {"loading", "a bag between two plates, one row per row of the series", demand_bag,
       [](const io::RunFile& run, const std::string& where) {
         return analysis::loading(run.series, loaded_bag(run, where));
       }},
      {"path", "paths of stress of such a bag and its groups up to the first break", demand_bag,
       [](const io::RunFile& run, const std::string& where) {
         return analysis::stress_paths(run.series, run.snapshots, loaded_bag(run, where));
       }},
      {"reinforced", "reinforced soil in a periodic cell, one row per row of the series",
       [](const io::RunFile& run, const std::string& where) { analysis::reinforced_cell(run, where); },
       [](const io::RunFile& run, const std::string& where) {
         return analysis::reinforced(run.series, analysis::reinforced_cell(run, where));
       }},
      {"interface", "friction of soil on a flat geotextile in a shear box, one row per row of the series",
       [](const io::RunFile& run, const std::string& where) { analysis::shear_box(run, where); },
       [](const io::RunFile& run, const std::string& where) {
         return analysis::interface(run.series, analysis::shear_box(run, where));
       }},
  };
  return all;
}

}  // namespace soilweave::packing
