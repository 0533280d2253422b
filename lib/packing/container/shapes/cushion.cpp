// A filled bag whose sides are straight from corner to corner.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/shapes/cushion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soilweave::packing {

Cushion::Seen Cushion::see(const Vec3& point) {
  const double x = std::abs(point.x()), y = std::abs(point.y());
  return {std::max(x, y), std::min(x, y), std::abs(point.z())};
}

double Cushion::half_width(double height) const {
  return core() + std::sqrt(std::max(side_radius * side_radius - height * height, 0.0));
}

Eigen::Vector2d Cushion::from_corner(const Seen& at, double height) const {
  const double middle = half_width(height) - corner_radius;
  return {at.far - middle, at.near - middle};
}

double Cushion::beyond(const Seen& at, double height) const {
  const Eigen::Vector2d m = from_corner(at, height);
  return m.cwiseMax(0).norm() + std::min(m[0], 0.0) - corner_radius;
}

bool Cushion::inside(const Seen& at) const { return at.height <= half_height && beyond(at, at.height) <= 0; }

bool Cushion::at_corner(const Seen& at) const {
  // The body is symmetric about x = y; the nearer side is the one towards which a point is farther out.
  const double out = at.far - core();
  const double height = out > 0 ? Profile::nearest(out, at.height, 0).y() : half_height;
  return from_corner(at, height).minCoeff() > 0;
}

double Cushion::height_on_corner(const Seen& at) const {
  double low = 0, high = half_height;
  // The squared distance to the corner first falls with height, then rises. Bisection finds the minimum to rounding.
  for (int k = 0; k < 60; ++k) {
    const double z = 0.5 * (low + high), widening = z / (half_width(z) - core());
    const Eigen::Vector2d m = from_corner(at, z).cwiseMax(0);
    const double across = m.norm() > 0 ? m.sum() / m.norm() : 1;
    const double slope = z - at.height + beyond(at, z) * across * widening;
    (slope < 0 ? low : high) = z;
  }
  return low > 0 ? high : 0;
}

double Cushion::depth(const Vec3& point) const {
  const Seen at = see(point);
  if (!at_corner(at)) return Profile::depth(std::max(at.far - core(), 0.0), point.z());
  const double height = height_on_corner(at), out = beyond(at, height), below_face = half_height - at.height;
  if (inside(at)) return std::min(below_face, std::hypot(out, height - at.height));
  return -std::hypot(std::max(out, 0.0), height - at.height);
}

double Cushion::volume(double depth) const {
  const double h = half_height - depth, s = side_radius - depth, c = core(), r = std::max(corner_radius - depth, 0.0);
  // Integrals over half the height of the half width beyond the core, and of its square.
  const double beyond = 0.5 * (h * std::sqrt(std::max(s * s - h * h, 0.0)) + s * s * std::asin(std::min(h / s, 1.0)));
  const double squared = h * (s * s - h * h / 3);
  return 8 * (c * c * h + 2 * c * beyond + squared) - 2 * h * (4 - std::numbers::pi) * r * r;
}

std::vector<Vec3> Cushion::spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                                  bool even) const {
  std::vector<Vec3> points = FilledBag::spread(box, cells, outside, even);
  // The parallel surface is rounder at its corners.
  if (outside > 0)
    for (Vec3& point : points) point = nearest(point, outside);
  return points;
}

Vec3 Cushion::nearest(const Vec3& point, double outside) const {
  const Seen at = see(point);
  if (at_corner(at)) {
    const double height = height_on_corner(at), middle = half_width(height) - corner_radius;
    // For a point above the face and within its corner the face is nearest, otherwise the corner's rounding.
    const Eigen::Vector2d m = from_corner(at, height).cwiseMax(0);
    const bool on_face = at.height > half_height && m.norm() < corner_radius;
    const double way = on_face ? 1 : (m.norm() > 0 ? corner_radius / m.norm() : 0);
    const Eigen::Vector2d on = Eigen::Vector2d::Constant(middle) + way * m;
    const bool along_x = std::abs(point.x()) >= std::abs(point.y());
    const Vec3 foot(std::copysign(along_x ? on[0] : on[1], point.x()),
                    std::copysign(along_x ? on[1] : on[0], point.y()), std::copysign(height, point.z()));
    return foot + (inside(at) ? -outside : outside) * (point - foot).normalized();
  }
  const Eigen::Index far = std::abs(point.x()) >= std::abs(point.y()) ? 0 : 1;
  const double out = at.far - core();
  const Eigen::Vector2d on = Profile::nearest(std::max(out, 0.0), point.z(), outside);
  Vec3 there = point;
  if (out > 0) there[far] = std::copysign(core() + on.x(), point[far]);
  there.z() = on.y();
  return there;
}

}  // namespace soilweave::packing
