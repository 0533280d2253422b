// A file of Gmsh as it stands: nodes, elements and groups by Gmsh's own numbers, with the lines they stand on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fem/mesh.h"

namespace soilweave::fem {

/// Gmsh's numbers of the element types that are taken.
namespace gmsh {
inline constexpr int line2 = 1, triangle3 = 2, line3 = 8, vertex = 15, quadrilateral8 = 16;
}

/// What is known of a type of Gmsh's elements: "6-node triangle" and 6; no nodes where the type is unknown.
struct GmshType {
  std::string_view name;
  int nodes = 0;
};
GmshType gmsh_type(int number);

struct GmshFile {
  struct Node {
    Vec3 at;           // m
    std::size_t line;  // of the file
  };
  struct Item {
    std::int64_t tag;
    std::size_t line;  // of the file
    int type;
    std::vector<int> groups;  // physical ones, without their sign, which is a sense
    std::vector<std::int64_t> nodes;
  };
  std::map<std::int64_t, Node> nodes;
  std::vector<Item> items;
  std::map<std::pair<int, int>, std::string> names;  // of groups, by dimension and number
};

/// The text of a file, ASCII 2.2 or 4.1; sections that say nothing of the mesh are skipped. Throws DataError with file
/// and line.
GmshFile parse_gmsh(std::string_view text, const std::string& where);

/// The plane mesh of a file. Elements that stand in it several times count once, clockwise ones are turned round, nodes
/// of no element are left out; the mesh's doubts say so. Throws DataError, by Gmsh's numbers, where elements are not
/// plane, without area, crossed or folded, overlap, or where a boundary is no side of an element.
Mesh build_mesh(const GmshFile& file, const std::string& where);

}  // namespace soilweave::fem
