// Nesting depth of a TOML document, checked before parsing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// Returns why a TOML text would overrun the parser's stack: a key or header of more than 32 parts, lists and tables
/// more than 32 deep, more than 16 MiB. Returns an empty text otherwise. The reason begins with line and column: "3:1:
/// a key of more than 32 parts".
std::string toml_excess(std::string_view text);

}  // namespace soilweave
