// VTK XML files (.vtp, .vtu) as bytes: appended raw encoding, UInt64 headers, TimeValue in the field data.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/tensor.h"

namespace soilweave::io {

/// One named array, `components` values per point or cell (9: a tensor, row major).
struct VtkArray {
  std::string name;
  int components = 1;
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::int32_t>, std::vector<std::uint8_t>>
      values;
};

/// Every cell of a picture has the same shape and takes the next 1, 2, 3, 4 or 8 points: no point is shared.
enum class VtkShape { vertex = 1, line = 2, triangle = 3, quad = 4, hexahedron = 8 };

/// What one VTK file shows.
struct VtkPicture {
  double time = 0;  // s
  std::int64_t step = 0;
  VtkShape shape = VtkShape::vertex;
  bool grid = false;         // a mesh: an unstructured grid (.vtu) whatever its shape
  std::vector<Vec3> points;  // m
  std::vector<VtkArray> point_data, cell_data;
};

/// PolyData: vertices, lines, triangles or quads. compress: zlib instead of raw. Equal pictures give equal bytes.
/// Throws DataError if an array's length disagrees with the points or cells.
std::string to_vtp(const VtkPicture& picture, bool compress = false);
/// UnstructuredGrid: any shape.
std::string to_vtu(const VtkPicture& picture, bool compress = false);

/// A surface as its file has it.
struct TriangleSoup {
  std::vector<Vec3> points;  // in the file's unit of length
  std::vector<std::array<std::size_t, 3>> triangles;
};
/// The polygons of a .vtp file, cut into triangles. Throws DataError where it is none. Null in programs without VTK.
[[gnu::weak]] TriangleSoup read_vtp(const std::string& path);

}  // namespace soilweave::io
