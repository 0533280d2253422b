// Which column of a text of spheres is which.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soilweave::io {

/// Columns of a text of spheres. Positions are counted from 0.
struct SphereColumns {
  std::size_t width = 0;  // columns a line
  std::size_t x = 0, y = 0, size = 0;
  std::optional<std::size_t> z;     // disks have none
  double size_factor = 1;           // from the column `size` to a radius in the unit of lengths: 1/2 for diameters
  double length_factor = 1;         // from the unit of lengths to m
  std::vector<std::string> unused;  // names of the other columns

  bool is_unused(std::size_t column) const { return column != x && column != y && column != size && z != column; }
};

/// Returns x y z r, or x y r for disks.
SphereColumns plain_columns(int dimension);

/// Returns the columns that a header names. Throws DataError saying which is missing, there twice, or in another unit.
SphereColumns named_columns(const std::vector<std::string>& names);

/// Returns the columns of YADE's line "#format x_y_z_r", "#format id_x_y_z_r_matId"; nothing for any other line.
/// Throws DataError where the line names something unknown.
std::optional<SphereColumns> yade_columns(std::string_view line);

/// Returns the columns that a comment such as "# x y z r" names; nothing where it names none.
std::optional<SphereColumns> commented_columns(std::string_view line);

/// Returns the names in a header line, a unit behind a blank joined to its name.
std::vector<std::string> header_names(std::string_view line, char separator);

}  // namespace soilweave::io
