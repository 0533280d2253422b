// Quantities as a person writes them: "100 kPa", "3 mm", "29 deg", "2650 kg/m3".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace soilweave {

inline constexpr double degree = std::numbers::pi / 180;  // rad

/// Returns the factor from unit `from` to unit `to` (1 kPa -> 1000 Pa). Throws DataError that names the part that is no
/// unit, or the two units that measure different things.
double unit_factor(std::string_view from, std::string_view to);

/// Throws DataError with the nearest unit if the text is none.
void demand_unit(std::string_view unit);

/// Returns the number in `text` in `unit`. Bare numbers have that unit; "100 kPa" is converted. Throws DataError if the
/// text is no number (with its spelling: "0,1 MPa" needs a point) or if its unit does not fit (with the nearest unit
/// for 'KPa'). nan and inf are accepted; callers judge them.
double quantity(std::string_view text, std::string_view unit);

}  // namespace soilweave
