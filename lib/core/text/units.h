// Quantities as a person writes them: "100 kPa", "3 mm", "29 deg", "2650 kg/m3".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace soilweave {

/// One degree, rad.
inline constexpr double degree = std::numbers::pi / 180;

/// Returns the factor from one unit to another (1 kPa -> 1000 Pa).
/// Throws DataError if a part is no unit, or if the units measure different things.
double unit_factor(std::string_view from, std::string_view to);

/// Returns the unit that a misspelt one probably is ("mm" for MM and for millimeter); empty if none is near.
std::string_view unit_meant(std::string_view word);

/// Throws DataError with the nearest unit if the text is none.
void demand_unit(std::string_view unit);

/// Returns the number in `text` in `unit`. Bare numbers have that unit; "100 kPa" is converted.
/// Throws DataError with a remedy if the text is no number or its unit does not fit. Accepts nan and inf.
double quantity(std::string_view text, std::string_view unit);

}  // namespace soilweave
