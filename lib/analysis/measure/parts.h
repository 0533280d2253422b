// Part of an assembly that a body belongs to: reinforced soil, fill around it, or nodes of a geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "display/vtk.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Parts, numbered as in the column `part` of tables and pictures.
enum class Part : std::uint8_t { soil = 0, fill = 1, node = 2 };

/// Returns for each grain whether it is a node of a geotextile.
std::vector<bool> nodes(const io::Snapshot& state);
/// Returns the part of each body. A node is an end of a yarn. If other grains belong to copies (copy_id >= 0), these
/// are the reinforced soil and the rest is fill. Without copies all grains except nodes are soil.
std::vector<Part> parts(const io::Snapshot& state);
/// Returns for each body whether it is of this part.
std::vector<bool> those(const std::vector<Part>& parts, Part part);
/// Returns whether some body is fill.
bool has_fill(const io::Snapshot& state);
/// Adds the array `part` to the picture of a state's grains, if there is fill.
void mark_parts(const io::Snapshot& state, io::VtkPicture& grains);

}  // namespace soilweave::analysis
