// Packings of spheres and disks as text, one grain a line, as YADE, spreadsheets and this house write them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/files.h"

namespace soilweave::io {

/// Properties of spheres that their text does not give.
struct SpheresOptions {
  double density = 0;              // kg/m3, of the grains
  std::optional<CellRecord> cell;  // periodic cell of a text without a ##PERIODIC:: line
  std::optional<int> dimension;    // 3: spheres, 2: disks; else from the ##PERIODIC:: line or the header
};

struct ImportedSpheres {
  Snapshot state;
  Source source;
  std::vector<std::string> notes;  // what was left out, one sentence each
};

/// Returns the periodic cell of lengths written as "LX,LY,LZ" (spheres) or "LX,LY" (disks), in m or with units.
/// Throws UsageError naming `what` where they are not that.
CellRecord periodic_cell(const std::string& lengths, const std::string& what);

/// Reads grains, one a line. Which column is which is said by a header (x, y, z and r, radius or diameter in any order,
/// with a unit as x [mm] or x_mm, other named columns are left out and noted), by YADE's #format line, or by a comment
/// that names as many columns; without any of them lines are exactly x y z r, for disks x y r. Columns are separated by
/// blanks and tabs, by commas or by semicolons, as in the first line. "##PERIODIC:: Lx Ly Lz" (disks: Lx Ly) before the
/// first grain gives the cell; without it the cell is the one given, or nothing is periodic.
/// Throws DataError naming line and column of anything else, and formats of other programs by name.
ImportedSpheres import_spheres(const std::filesystem::path& path, const SpheresOptions& options);

/// Returns the text that import_spheres reads back to the same grains: x y z r a line (disks: x y r below a header), in
/// full precision, with the ##PERIODIC:: line for an upright periodic cell.
std::string export_spheres(const Snapshot& state);

}  // namespace soilweave::io
