// Triangulated surfaces from STL files, binary and text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "io/vtk.h"

namespace soilweave::io {

/// Returns the triangles of an STL file, in the file's unit of length. Corners at one place are one point. A file whose
/// length fits its count of triangles is binary, even if it begins with "solid". where: what messages call the file.
/// Throws DataError with the line of a text, or with both lengths of a truncated binary file.
TriangleSoup read_stl(std::string_view bytes, const std::string& where);

}  // namespace soilweave::io
