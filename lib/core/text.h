// Numbers, names and paragraphs as text: what messages, help and settings share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"

namespace soilweave {

/// The known name fewest edits away, if near enough to be a slip of the finger; empty otherwise.
std::string nearest(std::string_view name, const std::vector<std::string>& known);

/// "; did you mean 'x'?" for the nearest known name, or the known names where none is near.
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

/// The shortest decimal text that reads back as the same double; long rows of zeros become an exponent.
std::string number_text(double value);

/// A positive number rounded to two significant digits, upwards or downwards: a value that a message names as a remedy
/// is on the safe side of the limit that it comes from.
double rounded_up(double value);
double rounded_down(double value);

/// "from 0 to 1 Pa", "above 0 Pa", "at least 2", … ; empty where the parameter is unbounded.
std::string range_text(const Parameter& parameter);

/// Why `value` is no good for the parameter (not finite, out of range), or nothing.
std::optional<std::string> range_mistake(double value, std::string_view as_given, const Parameter& parameter);

/// Paragraph broken at blanks so that no line is longer than `width`, unless a word is.
std::vector<std::string> wrapped(std::string_view paragraph, std::size_t width);

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(std::string_view text);

}  // namespace soilweave
