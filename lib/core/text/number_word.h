// Numbers as people and programs write them: one word per number, and the reason why a word is none.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soilweave {

/// Returns the text without blanks at its ends: spaces, tabs, no-break spaces (U+00A0, U+2007, U+202F), line ends.
std::string_view trimmed(std::string_view text);

/// Returns the text with ordinary spaces for no-break spaces.
std::string plain_spaces(std::string_view text);

/// Returns the number that the whole word spells, or nothing. A leading +, nan and inf are accepted; callers judge
/// them. Numbers beyond the range of a double give nothing. The locale has no influence.
std::optional<double> number_of(std::string_view word);

/// Returns how to spell a number that another program or language wrote: "write 10.5, with a decimal point" for 10,5;
/// "write 1.0e+00" for Fortran's 1.0D+00. Empty if nothing is known.
std::string number_remedy(std::string_view word);

/// Returns the sentence `"10,5" is no number: write 10.5, with a decimal point`. `what`: the expected kind, such as
/// "finite number".
std::string no_number(std::string_view word, std::string_view what = "number");

/// Returns the parts of a list with commas, without blanks at their ends: "a, b," gives "a", "b" and an empty part. A
/// text without commas is one part.
std::vector<std::string> parts_of_list(std::string_view list);
/// Returns the numbers of a list with commas; no numbers if some part is no finite number.
std::vector<double> numbers_of_list(std::string_view list);

}  // namespace soilweave
