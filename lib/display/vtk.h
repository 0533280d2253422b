// VTK XML files (.vtp, .vtu) as bytes: raw appended data, UInt64 headers, TimeValue.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/tensor.h"

namespace soilweave::io {

/// One named array of values per point or cell.
struct VtkArray {
  /// Name in ParaView.
  std::string name;
  /// Values per point or cell; 9: a tensor, row major.
  int components = 1;
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::int32_t>, std::vector<std::uint8_t>>
      values;
};

/// Shape of all cells. Each cell takes the next 1, 2, 3, 4 or 8 points; cells share no points.
enum class VtkShape { vertex = 1, line = 2, triangle = 3, quad = 4, hexahedron = 8 };

/// Content of one VTK file.
struct VtkPicture {
  /// Time, s.
  double time = 0;
  std::int64_t step = 0;
  VtkShape shape = VtkShape::vertex;
  /// True: unstructured grid (.vtu) of any shape.
  bool grid = false;
  /// Places, m.
  std::vector<Vec3> points;
  /// One value per point, or per cell.
  std::vector<VtkArray> point_data, cell_data;
};

/// Returns PolyData; `compress` means zlib. Equal pictures give equal bytes. Throws DataError if an array's length does
/// not fit.
std::string to_vtp(const VtkPicture& picture, bool compress = false);
/// Returns an UnstructuredGrid of any shape. Throws like to_vtp().
std::string to_vtu(const VtkPicture& picture, bool compress = false);

}  // namespace soilweave::io
