// How deep a TOML document nests, told before it is parsed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// Returns what is wrong with a TOML text that no reader of ours means and that would overrun the stack of the parser:
/// a key or header of more than 32 parts, lists and tables more than 32 deep, more than 16 MiB. Returns an empty string
/// for any other text. The answer begins with line and column, as in "3:1: a key of more than 32 parts".
std::string toml_excess(std::string_view text);

}  // namespace soilweave
