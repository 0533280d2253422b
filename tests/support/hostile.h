// Every reader, given bytes that nobody checked: what fuzzing and the test of its corpus call.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace soilweave::hostile {

/// Each reads the bytes in every way tools do, and uses what it got a little. Errors of ours are the right answer;
/// anything else leaves as it came.
void scenario(std::string_view bytes);  // TOML: scenarios, plans, materials, priors, soils, geotextiles
void table(std::string_view bytes);     // tab-separated text: series, gradings, observations
void spheres(std::string_view bytes);   // x y z r
void mesh(std::string_view bytes);      // of finite elements, by gmsh
void surface(std::string_view bytes);   // of triangles, in STL
void file(std::string_view bytes);      // HDF5 of every kind

using Reader = void (*)(std::string_view);
/// The reader of a name, as above; null for another.
Reader reader(std::string_view name);

}  // namespace soilweave::hostile
