// Friction between soil and a flat geotextile in a shear box.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::analysis {

/// Planes of a shear box, which touch the soil only.
struct ShearBox {
  /// Names of all planes.
  std::vector<std::string> planes;
  /// Names of the planes that face down.
  std::vector<std::string> lids;
};

/// Returns the shear box of a run. Throws DataError naming `where` unless the run has a series, a geotextile and named
/// planes of soil alone, one of them facing down.
ShearBox shear_box(const io::RunFile& run, const std::string& where);

/// Returns one row per row of the series (columns: files/FORMAT.md). The shear force is the planes' force on the soil
/// along their travel, which the sheet balances. The normal force is the force on the lid.
io::Series interface(const io::Series& run, const ShearBox& box);

}  // namespace soilweave::analysis
