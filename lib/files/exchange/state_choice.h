// The states of a file that --state names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace soilweave::io {

/// Adds a mistake if the text can name no states: all, first, last or a whole number.
void check_states(const std::string& which, std::vector<std::string>& mistakes);
/// Returns the named states, from 0, or from the end if negative. Throws UsageError naming `where` for a missing one.
std::vector<std::size_t> chosen_states(const std::string& which, std::size_t count, const std::string& where);

}  // namespace soilweave::io
