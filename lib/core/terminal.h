// Standard error and text for a terminal. Text can neither end a program nor steer a terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// Returns the text with escapes for everything that a terminal obeys: \t, \n, \x1b for control characters, \u{202e}
/// for signs that change the writing direction or are invisible, \xff for bytes that are not UTF-8. ASCII characters in
/// `as_they_are` ("\n\t") stay.
std::string printable(std::string_view text, std::string_view as_they_are = "");

/// Writes bytes to standard error. Failures are ignored, because they cannot be reported.
void tell(std::string_view bytes);

/// Occupies closed standard streams (0 to 2), so that no file opened later gets their number. Reading from and writing
/// to them still fails.
void occupy_standard_streams();

}  // namespace soilweave
