// Geotextiles by their data sheets: tension at 2 and 5 % of strain and at failure, along the machine and across it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/text/settings.h"
#include "gws/solution/geotextile.h"

namespace soilweave::gws {

/// One direction of a data sheet (ISO 10319, ASTM D4595), as far as it is given. Tensions in N/m.
struct DataSheet {
  std::optional<double> at_2, at_5, strength, failure_strain;
};

/// Returns the geotextile with the straight pieces between the points of the sheet as its curve; its stiffness is the
/// secant to failure until a response tells the strain that is reached. Throws DataError naming `where` for values that
/// are missing or contradict each other.
Geotextile of_sheet(const std::string& name, const DataSheet& sheet, const std::string& where);

/// Returns whether a TOML table describes a data sheet: tensions at strains, or a direction.
bool is_sheet(const Settings& table);

/// Reads a data sheet: tension_at_2, tension_at_5, strength and failure_strain, or the same in the tables [machine] and
/// [cross]. `direction`: "machine", "cross", or empty for the lesser value of each point, since the solution knows one
/// tension for the hoops of both directions. Mistakes in keys go to the document.
Geotextile read_sheet(Settings& table, const std::string& direction, const std::string& where);

}  // namespace soilweave::gws
