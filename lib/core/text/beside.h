// Keys that exclude each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string_view>

#include "core/text/settings.h"

namespace soilweave {

/// Adds a mistake for each of `others` that the table has, because `key` excludes it.
void refuse_beside(Settings& table, std::string_view key, std::initializer_list<std::string_view> others);

}  // namespace soilweave
