// Shape functions and integration points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/mesh/element.h"

#include <Eigen/LU>
#include <array>

namespace soilweave::fem {
namespace {

// Corners, then the middles of the sides, counter-clockwise.
constexpr std::array<double, 8> xi_of = {-1, 1, 1, -1, 0, 1, 0, -1}, eta_of = {-1, -1, 1, 1, -1, 0, 1, 0};

}  // namespace

std::string name_of(Shape shape) { return shape == Shape::triangle3 ? "triangle3" : "quadrilateral8"; }

std::vector<IntegrationPoint> integration_points(Shape shape, Integration integration) {
  if (shape == Shape::triangle3) return {{Vec2(1.0 / 3, 1.0 / 3), 0.5}};
  const bool reduced = integration == Integration::reduced;
  const double far = std::sqrt(reduced ? 1.0 / 3 : 0.6);
  const std::vector<double> at = reduced ? std::vector{-far, far} : std::vector{-far, 0.0, far};
  const std::vector<double> weight = reduced ? std::vector{1.0, 1.0} : std::vector{5.0 / 9, 8.0 / 9, 5.0 / 9};
  std::vector<IntegrationPoint> points;
  for (std::size_t j = 0; j < at.size(); ++j)
    for (std::size_t i = 0; i < at.size(); ++i) points.push_back({Vec2(at[i], at[j]), weight[i] * weight[j]});
  return points;
}

NodeValues shape_functions(Shape shape, const Vec2& at) {
  const double x = at[0], y = at[1];
  if (shape == Shape::triangle3) return Vec3(1 - x - y, x, y);
  NodeValues N(8);
  for (std::size_t k = 0; k < 8; ++k) {
    const double a = xi_of[k] * x, b = eta_of[k] * y;
    const auto row = static_cast<Eigen::Index>(k);
    if (k < 4)
      N[row] = 0.25 * (1 + a) * (1 + b) * (a + b - 1);
    else
      N[row] = xi_of[k] == 0 ? 0.5 * (1 - x * x) * (1 + b) : 0.5 * (1 + a) * (1 - y * y);
  }
  return N;
}

ElementNodes reference_gradients(Shape shape, const Vec2& at) {
  const double x = at[0], y = at[1];
  if (shape == Shape::triangle3) {
    ElementNodes d(2, 3);
    d << -1, 1, 0, -1, 0, 1;
    return d;
  }
  ElementNodes d(2, 8);
  for (std::size_t k = 0; k < 8; ++k) {
    const double p = xi_of[k], q = eta_of[k], a = p * x, b = q * y;
    const auto c = static_cast<Eigen::Index>(k);
    if (k < 4) {
      d(0, c) = 0.25 * p * (1 + b) * (2 * a + b);
      d(1, c) = 0.25 * q * (1 + a) * (a + 2 * b);
    } else if (p == 0) {
      d(0, c) = -x * (1 + b);
      d(1, c) = 0.5 * q * (1 - x * x);
    } else {
      d(0, c) = 0.5 * p * (1 - y * y);
      d(1, c) = -y * (1 + a);
    }
  }
  return d;
}

Gradients gradients(Shape shape, const Vec2& at, const ElementNodes& nodes) {
  const ElementNodes d = reference_gradients(shape, at);
  const Mat2 jacobian = d * nodes.transpose();  // dx_j/dxi_i
  return {jacobian.inverse() * d, jacobian.determinant()};
}

}  // namespace soilweave::fem
