// Triangles of a VTK file in programs that carry no VTK.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/error.h"
#include "packing/triangles.h"

namespace soilweave::packing {

TriangleSoup read_vtp(const std::string& path) {
  throw DataError(fmt::format("'{}': this program was built without VTK; convert the surface to .stl", path));
}

}  // namespace soilweave::packing
