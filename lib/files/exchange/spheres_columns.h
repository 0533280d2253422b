// Identifies the columns of a text of spheres by their names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soilweave::io {

/// Meaning of a column.
enum class SphereRole { x, y, z, radius, diameter, other };

/// Returns the meaning of a column from its name, which may have a unit, as in "x [mm]".
SphereRole column_role(const std::string& name);
/// Returns whether a word is a unit of length, such as mm.
bool is_length(std::string_view unit);

/// Columns of a text of spheres, counted from 0.
struct SphereColumns {
  /// Columns per line.
  std::size_t width = 0;
  /// Positions of the coordinates and of radius or diameter.
  std::size_t x = 0, y = 0, size = 0;
  std::optional<std::size_t> z;  // absent for disks
  /// Factor from `size` to a radius: 1/2 for diameters.
  double size_factor = 1;
  /// Factor from the unit of length to m, and whether the names have a unit.
  double length_factor = 1;
  bool has_unit = false;
  std::vector<std::string> unused;  // names of the other columns
  /// Columns that number the grains, and that tell the time, if there are any. They only show whether one packing is
  /// given.
  std::optional<std::size_t> id, time;

  /// Returns whether the column is ignored.
  bool is_unused(std::size_t column) const { return column != x && column != y && column != size && z != column; }
};

/// Returns x y z r; for disks x y r.
SphereColumns plain_columns(int dimension);

/// Returns the columns that a header names. Throws DataError naming a missing or repeated column or differing units.
SphereColumns named_columns(const std::vector<std::string>& names);

/// Returns the columns of YADE's line "#format x_y_z_r"; nothing for other lines. Throws DataError for unknown columns.
std::optional<SphereColumns> yade_columns(std::string_view line);

/// Returns the names in a header line, with a separate unit joined to its name.
std::vector<std::string> header_names(std::string_view line, char separator);

}  // namespace soilweave::io
