// Shape functions and integration points of plane elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/tensor.h"

namespace soilweave::fem {

/// Shapes of elements.
enum class Shape {
  /// Linear, one integration point.
  triangle3,
  /// Serendipity.
  quadrilateral8,
};
/// Integration of the 8-node quadrilateral: 2 x 2 or 3 x 3 points. The 2 x 2 rule is soft in bending, with one
/// hourglass mode that neighbours cannot share. The 3 x 3 rule integrates the undistorted mass exactly.
enum class Integration { reduced, full };

/// Greatest number of nodes of an element.
inline constexpr std::size_t most_nodes = 8;
/// Returns the number of nodes.
constexpr std::size_t nodes_of(Shape shape) { return shape == Shape::triangle3 ? 3 : 8; }
/// Returns the number of corners.
constexpr std::size_t corners_of(Shape shape) { return shape == Shape::triangle3 ? 3 : 4; }
/// Returns the name of a shape in scenarios.
std::string name_of(Shape shape);

/// 2 x n, one column per node.
using ElementNodes = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 8>;
/// One value per node.
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

/// Gradients at a position.
struct Gradients {
  /// dN/dx, 2 x n, 1/m.
  ElementNodes dN;
  /// Area that the reference area maps to; <= 0: the element is inverted.
  double area;
};
/// Returns them for an element with these nodes.
Gradients gradients(Shape shape, const Vec2& at, const ElementNodes& nodes);

}  // namespace soilweave::fem
