// The part of an assembly that each body belongs to: reinforced soil, fill around it, or the nodes of a geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "io/records.h"
#include "io/vtk.h"

namespace soilweave::analysis {

/// The numbers are those of the column `part` in tables and pictures.
enum class Part : std::uint8_t { soil = 0, fill = 1, node = 2 };

/// Which grains are nodes of geotextiles.
std::vector<bool> nodes(const io::Snapshot& state);
/// THE distinction of reinforced soil from fill, one entry a body. A node is an end of a yarn. Where some other grains
/// belong to a copy of a representative volume (copy_id >= 0), these are the reinforced soil, and the rest is fill. In
/// an assembly without copies all grains but nodes are soil.
std::vector<Part> parts(const io::Snapshot& state);
/// Which bodies are of one part.
std::vector<bool> those(const std::vector<Part>& parts, Part part);
bool has_fill(const io::Snapshot& state);
/// Adds the array `part` to the picture of a state's grains, where there is fill.
void mark_parts(const io::Snapshot& state, io::VtkPicture& grains);

}  // namespace soilweave::analysis
