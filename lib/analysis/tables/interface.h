// Friction between soil and a flat geotextile, from the forces of the walls of a shear box over the sheet.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::analysis {

/// Names of the planes around the soil of a shear box, which touch soil alone.
struct ShearBox {
  std::vector<std::string> planes;  // all
  std::vector<std::string> lids;    // planes that face down
};

/// Returns the shear box of a run. Throws DataError naming `where` and what the run lacks: a series, a geotextile, a
/// named plane that touches soil alone and faces down, or another one beside it.
ShearBox shear_box(const io::RunFile& run, const std::string& where);

/// Returns one row per row of the series; files/FORMAT.md lists the columns. The sheet balances the force of the planes
/// on the soil along their travel, under the force of the lid.
io::Series interface(const io::Series& run, const ShearBox& box);

}  // namespace soilweave::analysis
