// Triangulated surfaces of other programs: STL (binary, text) and VTK.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/tensor.h"

namespace soilweave::io {

/// A surface as in its file.
struct TriangleSoup {
  /// Corners in the file's unit of length.
  std::vector<Vec3> points;
  /// Indices of three points each.
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// Returns the triangles of an STL file. Corners at one place are one point. A length that fits the count of triangles
/// means binary, even after "solid". Throws DataError naming `where`.
TriangleSoup read_stl(std::string_view bytes, const std::string& where);
/// Returns the polygons of a .vtp file, cut into triangles. Throws DataError. Null in programs without VTK.
[[gnu::weak]] TriangleSoup read_vtp(const std::string& path);

}  // namespace soilweave::io
