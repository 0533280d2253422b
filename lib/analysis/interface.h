// Friction between soil and a flat geotextile: what the walls of a shear box push the soil by over the sheet.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/files.h"

namespace soilweave::analysis {

/// Names of the planes around the soil of a shear box, those that touch soil alone.
struct ShearBox {
  std::vector<std::string> planes;  // all
  std::vector<std::string> lids;    // those among them that face down
};

/// Returns the shear box of a run. Throws DataError naming `where` and what the run lacks: a series, a geotextile, a
/// named plane that touches soil alone and faces down, or another beside it.
ShearBox shear_box(const io::RunFile& run, const std::string& where);

/// One row per row of the series; the columns are listed in io/FORMAT.md. What the planes push the soil by along their
/// travel the sheet holds back, under the force of the lid.
io::Series interface(const io::Series& run, const ShearBox& box);

}  // namespace soilweave::analysis
