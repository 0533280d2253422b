// Numbers as people and programs write them, one word each, and the reason why a word is not a number.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soilweave {

/// Returns the text without spaces, tabs, no-break spaces and line ends at its ends.
std::string_view trimmed(std::string_view text);

/// Returns the text with ordinary spaces for no-break spaces.
std::string plain_spaces(std::string_view text);

/// Returns the number that the whole word spells, in any locale, or nothing.
/// Accepts nan and inf, but no number beyond the range of a double.
std::optional<double> number_of(std::string_view word);

/// Returns how to spell a number ("write 10.5, with a decimal point" for 10,5), or an empty text.
std::string number_remedy(std::string_view word);

/// Returns the sentence `"10,5" is no number: write 10.5, with a decimal point`.
/// `what`: the expected kind, such as "finite number".
std::string no_number(std::string_view word, std::string_view what = "number");

/// Returns the parts of a list with commas, trimmed. "a, b," has three parts, the last one empty.
std::vector<std::string> parts_of_list(std::string_view list);
/// Returns the numbers of a list with commas; none if a part is no finite number.
std::vector<double> numbers_of_list(std::string_view list);

}  // namespace soilweave
