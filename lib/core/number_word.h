// Numbers as people and programs write them: one word to a number, and why a word is none.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace soilweave {

/// Returns the text without blanks at its ends: spaces, tabs and no-break spaces (U+00A0, U+2007, U+202F), line ends.
std::string_view trimmed(std::string_view text);

/// Returns the text with an ordinary space for each no-break space.
std::string plain_spaces(std::string_view text);

/// Returns the number that the whole word is. A leading + is taken, and so are nan and inf, which the caller judges.
/// Returns nothing for any other word and for numbers that a double cannot hold. The locale is never asked.
std::optional<double> number_of(std::string_view word);

/// Returns what to write instead of a word that is no number, for the ways in which other programs and languages write
/// one: "write 10.5, with a decimal point" for 10,5; "write 1.0e+00" for Fortran's 1.0D+00. Empty where nothing is
/// known.
std::string number_remedy(std::string_view word);

/// Returns the sentence `"10,5" is no number: write 10.5, with a decimal point`. `what` is what the word should have
/// been: "number", "finite number".
std::string no_number(std::string_view word, std::string_view what = "number");

}  // namespace soilweave
