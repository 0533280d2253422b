// Surfaces of triangles from STL files, binary and text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "io/vtk.h"

namespace soilweave::io {

/// The triangles of an STL file, in the file's unit of length; corners at the same place are one point. A file as long
/// as its count of triangles says is binary, even where its first word is "solid". where: what messages call the file.
/// Throws DataError: of text with the line, of a binary file that is cut short with both lengths.
TriangleSoup read_stl(std::string_view bytes, const std::string& where);

}  // namespace soilweave::io
