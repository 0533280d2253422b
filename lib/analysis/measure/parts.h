// Parts of an assembly: reinforced soil, fill around it, nodes of a geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "display/vtk.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Parts, numbered as in the column `part` of tables and pictures.
enum class Part : std::uint8_t { soil = 0, fill = 1, node = 2 };

/// Returns the part of each body. Copies (copy_id >= 0) are reinforced soil, the rest fill. Without copies all is soil.
/// A node is an end of a yarn.
std::vector<Part> parts(const io::Snapshot& state);
/// Returns for each body whether it is `part`.
std::vector<bool> those(const std::vector<Part>& parts, Part part);
/// Returns whether some body is fill.
bool has_fill(const io::Snapshot& state);
/// Adds the array `part` to the picture if there is fill.
void mark_parts(const io::Snapshot& state, io::VtkPicture& grains);

}  // namespace soilweave::analysis
