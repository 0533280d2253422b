// Standard error and the words that reach a terminal: nothing that is said can end a program or steer a terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// The text with everything that a terminal would obey written out: control characters as \t, \n, \x1b, signs that turn
/// the direction of writing or hide themselves as \u{202e}, bytes that are no UTF-8 as \xff. Characters in
/// `as_they_are` (ASCII, as "\n\t") stay.
std::string printable(std::string_view text, std::string_view as_they_are = "");

/// Writes bytes to standard error. What cannot be written (a full disk, a closed or hung-up terminal) is lost without
/// a word: there is no place to say it, and the work is worth more than what is said about it.
void tell(std::string_view bytes);

/// Gives closed standard streams a number of their own (0 to 2), so that no file opened later takes it: reading such a
/// stream and writing to it still fail.
void occupy_standard_streams();

}  // namespace soilweave
