// Geotextiles by data sheet: tensions at 2 and 5 % of strain and at failure.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/text/settings.h"
#include "gws/solution/geotextile.h"

namespace soilweave::gws {

/// One direction of a data sheet (ISO 10319, ASTM D4595). Absent values are empty.
struct DataSheet {
  /// Tensions, N/m; failure strain, 1.
  std::optional<double> at_2, at_5, strength, failure_strain;
};

/// Returns the geotextile with straight pieces between the points as its curve. Its stiffness is the secant to failure
/// until a response gives the strain. Throws DataError naming `where` for missing or contradictory values.
Geotextile of_sheet(const std::string& name, const DataSheet& sheet, const std::string& where);

/// Returns whether a table is a data sheet: it has tensions at strains, or a direction.
bool is_sheet(const Settings& table);

/// Reads tension_at_2, tension_at_5, strength and failure_strain, at the top or in [machine] and [cross]. direction:
/// "machine", "cross", or empty for the lower envelope of both directions, since the solution knows one tension only.
/// The envelope has the lesser tension at each strain, the lesser strength, and the greater strain at that strength.
/// Throws DataError for a missing direction. Other mistakes go to the document.
Geotextile read_sheet(Settings& table, const std::string& direction, const std::string& where);

}  // namespace soilweave::gws
