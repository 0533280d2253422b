// Tables of a whole run, from the list that the build makes of the files in tables/.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/run_tables.h"

#include "core/error.h"
#include "lists/tables.h"

namespace soilweave::packing {
namespace {

template <class... T>
std::vector<RunTable> listed_tables() {
  return {RunTable{T::name, T::long_name, &T::demand, &T::make}...};
}

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
  using namespace tables;
  static const std::vector<RunTable> all = listed_tables<SOILWEAVE_TABLES>();
  return all;
}

}  // namespace soilweave::packing
