// A plane mesh: nodes, elements of one shape, named boundaries. From a generator, or from Gmsh's text files.
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

/// Edges in the order of the domain's contour: counter-clockwise, with the domain on the left.
struct Boundary {
  std::vector<std::array<Index, 2>> ends;  // corner nodes
  std::vector<Index> middle;               // node in between, only for 8-node quadrilaterals
  std::vector<Index> nodes;                // all nodes, ascending; a boundary of points has only these
};

/// A mesh of triangles or quadrilaterals.
struct Mesh {
  Shape shape = Shape::triangle3;
  std::vector<Vec2> nodes;                              // m
  std::vector<std::array<Index, most_nodes>> elements;  // counter-clockwise, corners first
  std::map<std::string, Boundary, std::less<>> boundaries;
  std::vector<std::int64_t> node_tags;  // numbers of the nodes in their file; empty for a rectangle
  std::vector<Doubt> doubts;            // about the file: elements reversed or repeated, nodes left out

  /// Returns the number of nodes of an element.
  Index nodes_of_element() const { return nodes_of(shape); }
  /// Returns the corners of an element at the given positions.
  ElementNodes corners(Index element, const std::vector<Vec2>& positions) const;
  /// Throws DataError, naming the element and the likely cause, for node numbers out of range, an element without area
  /// or inverted, a node of no element, and an invalid boundary.
  void check(const std::string& where) const;
  /// Returns the boundary of this name. Throws DataError naming the nearest one.
  const Boundary& boundary(const std::string& name) const;
  /// Joins boundaries to one line of nodes, corner to corner. Throws DataError if they do not connect in this order.
  std::vector<Index> line(const std::vector<std::string>& names) const;
  /// Returns pairs of coincident nodes, within a hundred-millionth of the mesh size.
  std::vector<std::array<Index, 2>> coincident() const;
  /// A piece of the mesh that shares no node with others: its elements, and the mean of its nodes, m.
  struct Piece {
    Index elements = 0;
    Vec2 middle = Vec2::Zero();
  };
  /// Returns the pieces that share no node.
  std::vector<Piece> pieces() const;
};

/// Returns a rectangle from (0, 0) of columns x rows squares. Triangles are cut by the diagonal from bottom right to
/// top left, as in the thesis's meshes. Boundaries: bottom, right, top, left, and bottom-corners, which has nodes only.
Mesh rectangle(double width, double height, Index columns, Index rows, Shape shape);

/// Reads Gmsh's MSH format, ASCII, 2.2 and 4.1: triangles of 3 or quadrilaterals of 8 nodes in the plane z = 0, and
/// boundaries from named physical groups of lines and points. An element in several groups counts once, a clockwise one
/// is reversed, a node of no element is left out (doubts). Throws DataError with the line and Gmsh's numbers.
Mesh read_gmsh(std::string_view text, const std::string& where);

}  // namespace soilweave::fem
