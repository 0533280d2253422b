// Every reader under unchecked bytes, for fuzzing and for the test of its corpus.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace soilweave::hostile {

/// Each function reads the bytes in every way that tools do, and uses the result a little. It catches errors of the
/// library, which are the right answer, and nothing else.
void scenario(std::string_view bytes);  // TOML: scenarios, plans, materials, priors, soils, geotextiles
void table(std::string_view bytes);     // tab-separated text: series, gradings, observations
void spheres(std::string_view bytes);   // x y z r
void mesh(std::string_view bytes);      // of finite elements, by Gmsh
void surface(std::string_view bytes);   // of triangles, in STL
void file(std::string_view bytes);      // HDF5 of every kind

using Reader = void (*)(std::string_view);
/// Returns the reader of this name, nullptr for another name.
Reader reader(std::string_view name);

}  // namespace soilweave::hostile
