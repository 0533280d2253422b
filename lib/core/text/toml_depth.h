// Nesting depth of a TOML document, checked before parsing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// Returns why a TOML text would overrun the parser's stack, with line and column; otherwise an empty text.
/// Limits: 32 parts of a key or header, 32 nested lists and tables, 16 MiB.
std::string toml_excess(std::string_view text);

}  // namespace soilweave
