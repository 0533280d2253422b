// Keys that exclude each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/beside.h"

#include <fmt/format.h>

namespace soilweave {

void refuse_beside(Settings& table, std::string_view key, std::initializer_list<std::string_view> others) {
  for (const std::string_view other : others)
    if (table.has(other)) table.mistake(other, fmt::format("is given beside {}: leave one of the two out", key));
}

}  // namespace soilweave
