// Packings as text, one grain per line, as YADE, spreadsheets and to-vtk write them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::io {

/// Properties of spheres that their text lacks.
struct SpheresOptions {
  /// Density of the grains, kg/m3.
  double density = 0;
  /// Periodic cell if the text has no line ##PERIODIC::.
  std::optional<CellRecord> cell;
  /// 3: spheres, 2: disks. If unset, ##PERIODIC:: or the header tells it.
  std::optional<int> dimension;
};

/// Grains read from a text.
struct ImportedSpheres {
  Snapshot state;
  Source source;
  /// One sentence for each kind of content that was left out.
  std::vector<std::string> notes;
};

/// Returns the cell for "LX,LY,LZ" (disks: "LX,LY"), in m or with units. Throws UsageError naming `what`.
CellRecord periodic_cell(const std::string& lengths, const std::string& what);

/// Reads grains, one per line.
/// - Columns are named by a header, by YADE's #format line, or by a comment with one word for each column. The names
///   are x, y, z, and r, radius or diameter, in any order. A unit may follow, as x [mm] or x_mm. Other columns are left
///   out and noted. A comment may give the unit of all lengths ("# units: mm"). A comment that contradicts the header
///   is refused, and so are unclear column names in a comment without a header.
/// - Without names, a line is exactly x y z r (disks: x y r).
/// - The first line determines the separator: blanks and tabs, commas or semicolons.
/// - "##PERIODIC:: Lx Ly Lz" (disks: Lx Ly) before the first grain gives the cell, in the unit of the columns. Without
///   this line the cell is options.cell; without that, it is aperiodic.
/// Throws DataError with line and column for any other content. The message names the format of another program.
ImportedSpheres import_spheres(const std::filesystem::path& path, const SpheresOptions& options);

/// Text of a packing.
struct ExportedSpheres {
  std::string text;
  /// Nodes, planes, contacts and other content that the text leaves out, for people; empty if there is none.
  std::string left_out;
};

/// Returns a text that import_spheres() reads back exactly. An upright periodic cell becomes the line ##PERIODIC::.
/// Nodes of geotextiles are left out. Throws DataError naming `where` if no grains remain.
ExportedSpheres export_spheres(const Snapshot& state, const std::string& where);

}  // namespace soilweave::io
