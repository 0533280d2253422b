// Quantities as a person writes them: "100 kPa", "3 mm", "29 deg", "2650 kg/m3".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace soilweave {

/// Factor that turns a number in unit `from` into one in unit `to` (1 kPa -> 1000 Pa).
/// Throws DataError naming the part that is no unit, or the two units that measure different things.
double unit_factor(std::string_view from, std::string_view to);

/// Throws DataError with the nearest unit where the text is none.
void demand_unit(std::string_view unit);

/// The number in `text`, converted to `unit`: bare numbers are in that unit already, "100 kPa" is converted.
/// Throws DataError when the text is no number (saying how to write it: "0,1 MPa" with a point) or its unit does not
/// fit (naming the nearest: 'KPa'). nan and inf are read, not judged.
double quantity(std::string_view text, std::string_view unit);

}  // namespace soilweave
