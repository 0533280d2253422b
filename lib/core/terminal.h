// Terminal output in which text cannot act as a control sequence.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// Returns the text with escapes (\n, \x1b, \u{202e}, \xff) for control characters, invisible characters, marks of
/// direction, and bytes that are not UTF-8. ASCII characters in `as_they_are` stay.
std::string printable(std::string_view text, std::string_view as_they_are = "");

/// Writes bytes to standard error. Failures are ignored, because they cannot be reported.
void tell(std::string_view bytes);

/// Opens closed standard streams, so that no later file gets their number. Reading and writing them still fails.
void occupy_standard_streams();

}  // namespace soilweave
