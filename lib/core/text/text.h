// Numbers, names and paragraphs as text, for messages, help and settings.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"

namespace soilweave {

/// Returns the text with small letters for capitals (of ASCII).
std::string lower_case(std::string_view text);

/// Returns the nearest known name by edits, or an empty text if none is near.
std::string nearest(std::string_view name, const std::vector<std::string>& known);

/// Returns "; did you mean 'x'?" for the nearest known name, or lists the known names if none is near.
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

/// Returns the shortest decimal text that reads back as the same double. Long rows of zeros become an exponent.
std::string number_text(double value);

/// Returns a duration with two or three figures: "45 s", "3.5 min", "12.4 h".
std::string time_text(double seconds);

/// Returns a positive number rounded up to two significant digits, for remedies in messages.
double rounded_up(double value);
/// Returns a positive number rounded down to two significant digits.
double rounded_down(double value);

/// Returns "from 0 to 1 Pa", "above 0 Pa", "at least 2", ...; empty if the parameter is unbounded.
std::string range_text(const Parameter& parameter);

/// Returns why `value` is inadmissible (not finite, out of range), or nothing.
std::optional<std::string> range_mistake(double value, std::string_view as_given, const Parameter& parameter);

/// Breaks a paragraph at blanks into lines of at most `width` characters; longer words stay whole.
std::vector<std::string> wrapped(std::string_view paragraph, std::size_t width);

/// Returns the lines of a text, without their ends.
std::vector<std::string> lines_of(std::string_view text);

}  // namespace soilweave
