// A plane mesh: nodes, elements of one shape, named boundaries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/doubts.h"
#include "core/tensor.h"
#include "fem/mesh/element.h"

namespace soilweave::fem {

using Index = std::size_t;

/// Edges along the contour, counter-clockwise, with the domain on the left.
struct Boundary {
  /// Corner nodes.
  std::vector<std::array<Index, 2>> ends;
  /// Nodes in between, only for 8-node quadrilaterals.
  std::vector<Index> middle;
  /// All nodes, ascending. A boundary of points has only these.
  std::vector<Index> nodes;
};

/// A mesh of triangles or quadrilaterals.
struct Mesh {
  Shape shape = Shape::triangle3;
  /// Positions, m.
  std::vector<Vec2> nodes;
  /// Nodes of each element, counter-clockwise, corners first.
  std::vector<std::array<Index, most_nodes>> elements;
  std::map<std::string, Boundary, std::less<>> boundaries;
  /// Names that several groups of a file have, each with a message that names them; no boundary has these names.
  std::map<std::string, std::string, std::less<>> ambiguous;
  /// Numbers of nodes in their file; empty for a rectangle.
  std::vector<std::int64_t> node_tags;
  /// Numbers of elements in their file; empty for a rectangle.
  std::vector<std::int64_t> element_tags;
  /// Elements reversed or repeated, nodes left out.
  std::vector<Doubt> doubts;

  /// Returns the number of nodes of an element.
  Index nodes_of_element() const { return nodes_of(shape); }
  /// Returns the corners of an element at given positions.
  ElementNodes corners(Index element, const std::vector<Vec2>& positions) const;
  /// Throws DataError with element and likely cause for node numbers out of range, an element without area or inverted,
  /// a node of no element, and an invalid boundary.
  void check(const std::string& where) const;
  /// Returns the boundary of this name. Throws DataError naming the nearest one, or the groups that share the name.
  const Boundary& boundary(const std::string& name) const;
  /// Returns the boundary of this name. Throws DataError naming one with edges if there is none or if it has only
  /// points.
  const Boundary& boundary_with_edges(const std::string& name) const;
  /// Returns the nodes of the boundary of this name, or every node for "all". Throws DataError where boundary() does,
  /// and for "all" where a boundary has that name.
  std::vector<Index> nodes_on(const std::string& name) const;
  /// Joins boundaries to one line of nodes. Throws DataError if they do not connect in this order.
  std::vector<Index> line(const std::vector<std::string>& names) const;
  /// Returns the distance within which nodes coincide, m: 1e-8 of the mesh size.
  double coincidence() const;
  /// Returns pairs of coincident nodes.
  std::vector<std::array<Index, 2>> coincident() const;
  /// A node on a side of an element that does not have it.
  struct Hanging {
    Index node, element;
    /// Ends of the side.
    std::array<Index, 2> ends;
  };
  /// Returns the hanging nodes, ascending, each with one side. A node at an end of a side is coincident, not hanging.
  std::vector<Hanging> hanging() const;
  /// A piece of the mesh that shares no node with others.
  struct Piece {
    /// Number of its elements.
    Index elements = 0;
    /// Its nodes, ascending.
    std::vector<Index> nodes;
    /// Mean of its nodes, m.
    Vec2 middle = Vec2::Zero();
  };
  /// Returns all pieces.
  std::vector<Piece> pieces() const;
};

/// Returns a rectangle of squares from (0, 0). The diagonals of triangles run from bottom right to top left, as in the
/// thesis. Boundaries: bottom, right, top, left, and bottom-corners, which has nodes only.
Mesh rectangle(double width, double height, Index columns, Index rows, Shape shape);

/// Reads Gmsh's MSH format, ASCII, 2.2 and 4.1: triangles of 3 or quadrilaterals of 8 nodes in z = 0. Boundaries are
/// named physical groups of lines and points. For repairs and errors see parse_gmsh() and build_mesh().
Mesh read_gmsh(std::string_view text, const std::string& where);

}  // namespace soilweave::fem
