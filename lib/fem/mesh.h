// A plane mesh: nodes, elements of one shape, boundaries by name. From a generator, or from Gmsh's text files.
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
#include "fem/element.h"

namespace soilweave::fem {

using Index = std::size_t;

/// Edges in the sense of the domain's contour: counter-clockwise about it, the domain to their left.
struct Boundary {
  std::vector<std::array<Index, 2>> ends;  // corner nodes
  std::vector<Index> middle;               // the node between them, 8-node quadrilaterals only
  std::vector<Index> nodes;                // all of them, ascending; a boundary of points has these alone
};

struct Mesh {
  Shape shape = Shape::triangle3;
  std::vector<Vec2> nodes;                              // m
  std::vector<std::array<Index, most_nodes>> elements;  // counter-clockwise, corners first
  std::map<std::string, Boundary, std::less<>> boundaries;
  std::vector<std::int64_t> node_tags;  // of nodes in the file they come from; none of a rectangle
  std::vector<Doubt> doubts;            // about the file: what was turned round, counted once or left out

  Index nodes_of_element() const { return nodes_of(shape); }
  /// Corners of an element where they are now.
  ElementNodes corners(Index element, const std::vector<Vec2>& positions) const;
  /// Throws DataError naming the element and the likely cause: node numbers out of range, an element without area or
  /// turned over, a node of no element, a boundary that is none.
  void check(const std::string& where) const;
  /// The boundary of this name. Throws DataError naming the nearest one.
  const Boundary& boundary(const std::string& name) const;
  /// The boundaries joined to one line of nodes, corner to corner. Throws DataError where they are not connected in
  /// this order.
  std::vector<Index> line(const std::vector<std::string>& names) const;
  /// Pairs of nodes that lie on one another, to a hundred-millionth of the mesh.
  std::vector<std::array<Index, 2>> coincident() const;
  /// The pieces that share no node: elements of each, and the mean of its nodes, m.
  struct Piece {
    Index elements = 0;
    Vec2 middle = Vec2::Zero();
  };
  std::vector<Piece> pieces() const;
};

/// A rectangle from (0, 0) of columns x rows squares; triangles are cut by the diagonal from bottom right to top left,
/// as in the thesis's meshes. Boundaries: bottom, right, top, left, and of nodes alone bottom-corners.
Mesh rectangle(double width, double height, Index columns, Index rows, Shape shape);

/// Gmsh's MSH format, ASCII, 2.2 and 4.1: triangles of 3 or quadrilaterals of 8 nodes in the plane z = 0, boundaries
/// from physical groups of lines and points, by name. An element of several groups counts once, a clockwise one is
/// turned round, a node of no element left out (doubts). Throws DataError with the line and Gmsh's numbers.
Mesh read_gmsh(std::string_view text, const std::string& where);

}  // namespace soilweave::fem
