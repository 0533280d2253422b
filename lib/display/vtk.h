// VTK XML files (.vtp, .vtu) as bytes: appended raw encoding, UInt64 headers, TimeValue in the field data.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/tensor.h"

namespace soilweave::io {

/// One named array with `components` values per point or cell (9: a tensor, row major).
struct VtkArray {
  std::string name;
  int components = 1;
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::int32_t>, std::vector<std::uint8_t>>
      values;
};

/// Shape of all cells of a picture. Each cell takes the next 1, 2, 3, 4 or 8 points; cells share no points.
enum class VtkShape { vertex = 1, line = 2, triangle = 3, quad = 4, hexahedron = 8 };

/// Content of one VTK file.
struct VtkPicture {
  double time = 0;  // s
  std::int64_t step = 0;
  VtkShape shape = VtkShape::vertex;
  bool grid = false;         // true: unstructured grid (.vtu), whatever the shape
  std::vector<Vec3> points;  // m
  std::vector<VtkArray> point_data, cell_data;
};

/// Returns PolyData. compress: zlib instead of raw. Equal pictures give equal bytes. Throws DataError if an array's
/// length disagrees with the points or cells.
std::string to_vtp(const VtkPicture& picture, bool compress = false);
/// Returns an UnstructuredGrid of any shape.
std::string to_vtu(const VtkPicture& picture, bool compress = false);

}  // namespace soilweave::io
