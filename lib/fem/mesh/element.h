// Shape functions and integration points of the plane elements, as pure functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/tensor.h"

namespace soilweave::fem {

/// Shapes of elements.
enum class Shape {
  triangle3,       // linear, one integration point
  quadrilateral8,  // serendipity
};
/// Integration of the 8-node quadrilateral: 2 x 2 or 3 x 3 points. The 2 x 2 rule is soft in bending and has one
/// hourglass mode that neighbours cannot share. The 3 x 3 rule integrates the mass of an undistorted element exactly.
enum class Integration { reduced, full };

inline constexpr std::size_t most_nodes = 8;
/// Return the number of nodes, and of corners, of a shape.
constexpr std::size_t nodes_of(Shape shape) { return shape == Shape::triangle3 ? 3 : 8; }
constexpr std::size_t corners_of(Shape shape) { return shape == Shape::triangle3 ? 3 : 4; }
/// Returns the name of a shape, as scenarios write it.
std::string name_of(Shape shape);

/// 2 x n, one column per node.
using ElementNodes = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 8>;
using NodeValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1>;

/// A position in the reference element, with its weight.
struct IntegrationPoint {
  Vec2 at;
  double weight;
};
/// Returns the integration points of a shape; triangles always have one.
std::vector<IntegrationPoint> integration_points(Shape shape, Integration integration);

/// Returns the shape functions N at a position in the reference element.
NodeValues shape_functions(Shape shape, const Vec2& at);
/// Returns dN/dxi, 2 x n.
ElementNodes reference_gradients(Shape shape, const Vec2& at);

/// dN/dx at a position (2 x n, 1/m), and the area that the reference area maps to. Area <= 0: the element is inverted.
struct Gradients {
  ElementNodes dN;
  double area;
};
/// Computes them for an element with these nodes.
Gradients gradients(Shape shape, const Vec2& at, const ElementNodes& nodes);

}  // namespace soilweave::fem
