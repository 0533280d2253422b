// Texts of spheres in the formats of other programs, known by their first lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave::io {

/// Returns what a text is that is no plain list of spheres, with the commands that make one of it: "a dump of LAMMPS or
/// LIGGGHTS; write ...". Returns an empty string for any other text. Lines end by line feeds.
std::string foreign_spheres(std::string_view text);

}  // namespace soilweave::io
