// Content of a Gmsh file by Gmsh's own numbers, with lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fem/mesh/mesh.h"

namespace soilweave::fem {

/// Gmsh's numbers of accepted element types.
namespace gmsh {
inline constexpr int line2 = 1, triangle3 = 2, line3 = 8, vertex = 15, quadrilateral8 = 16;
}

/// Name and nodes of a Gmsh type, as "6-node triangle" and 6; 0 for an unknown type.
struct GmshType {
  std::string_view name;
  int nodes = 0;
};
/// Returns the type of a number.
GmshType gmsh_type(int number);

/// A parsed file.
struct GmshFile {
  /// One node.
  struct Node {
    /// Position, m.
    Vec3 at;
    /// Line in the file.
    std::size_t line;
  };
  /// One element, with its groups.
  struct Item {
    std::int64_t tag;
    /// Line in the file.
    std::size_t line;
    int type;
    /// Physical groups without sign, which is an orientation.
    std::vector<int> groups;
    std::vector<std::int64_t> nodes;
  };
  std::map<std::int64_t, Node> nodes;
  std::vector<Item> items;
  /// Names of groups, by dimension and number.
  std::map<std::pair<int, int>, std::string> names;
};

/// Parses a file, ASCII 2.2 or 4.1, without sections unrelated to the mesh. Throws DataError with file and line.
GmshFile parse_gmsh(std::string_view text, const std::string& where);

/// Builds the plane mesh. Repeated elements count once, clockwise elements are reversed, and nodes without an element
/// are left out. Doubts report these changes. Throws DataError with Gmsh's numbers for elements that are not plane,
/// have no area, are crossed or folded, or overlap, and for a boundary that is no side of an element.
Mesh build_mesh(const GmshFile& file, const std::string& where);

}  // namespace soilweave::fem
