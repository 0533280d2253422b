// Triangles of a VTK file, as they are. Two sources define it: with VTK, and without it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/tensor.h"

namespace soilweave::packing {

struct TriangleSoup {
  std::vector<Vec3> points;  // in the file's unit of length
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// The polygons of a .vtp file, cut into triangles. Throws DataError where it is none, and where this build has no VTK.
TriangleSoup read_vtp(const std::string& path);

}  // namespace soilweave::packing
