// Content of a Gmsh file: nodes, elements and groups by Gmsh's own numbers, with their lines.
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

/// Gmsh's numbers of the accepted element types.
namespace gmsh {
inline constexpr int line2 = 1, triangle3 = 2, line3 = 8, vertex = 15, quadrilateral8 = 16;
}

/// Name and number of nodes of a Gmsh element type: "6-node triangle" and 6; no nodes for an unknown type.
struct GmshType {
  std::string_view name;
  int nodes = 0;
};
/// Returns the description of a Gmsh element number.
GmshType gmsh_type(int number);

/// A parsed file.
struct GmshFile {
  /// One node.
  struct Node {
    Vec3 at;           // m
    std::size_t line;  // line in the file
  };
  /// One element, with its groups.
  struct Item {
    std::int64_t tag;
    std::size_t line;  // line in the file
    int type;
    std::vector<int> groups;  // physical groups without sign; the sign is an orientation
    std::vector<std::int64_t> nodes;
  };
  std::map<std::int64_t, Node> nodes;
  std::vector<Item> items;
  std::map<std::pair<int, int>, std::string> names;  // names of groups, by dimension and number
};

/// Parses a file, ASCII 2.2 or 4.1. Sections that do not concern the mesh are skipped. Throws DataError with file and
/// line.
GmshFile parse_gmsh(std::string_view text, const std::string& where);

/// Builds the plane mesh of a file. Repeated elements count once, clockwise ones are reversed, and nodes of no element
/// are left out; the mesh's doubts say so. Throws DataError, with Gmsh's numbers, for elements that are not plane, have
/// no area, are crossed or folded, or overlap, and for a boundary that is no side of an element.
Mesh build_mesh(const GmshFile& file, const std::string& where);

}  // namespace soilweave::fem
