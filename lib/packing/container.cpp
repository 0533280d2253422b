// The bag of the thesis, and an upright box.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "packing/chart.h"

namespace soilweave::packing {
namespace {

using std::numbers::pi;

// A point of the outline of a square of the given half width whose corners are rounded with radius r; u and v name it
// on the square's own outline, along which a side is divided evenly.
Eigen::Vector2d on_outline(double u, double v, double half, double r) {
  const bool along_y = std::abs(u) >= std::abs(v);  // on the side x = +-half
  const double side = along_y ? u : v, along = along_y ? v : u;
  const double ring = std::abs(side);
  if (ring == 0) return {0, 0};
  const double straight = half - r;
  const double s = std::abs(along) / ring * (straight + 0.25 * pi * r);
  double across = half, at = s;
  if (s > straight) {
    const double angle = (s - straight) / std::max(r, 1e-300);
    across = straight + r * std::cos(angle);
    at = straight + r * std::sin(angle);
  }
  const double a = std::copysign(across, side), b = std::copysign(at, along);
  return along_y ? Eigen::Vector2d(a, b) : Eigen::Vector2d(b, a);
}

}  // namespace

Pillow Pillow::read(Settings& table) {
  static constexpr Parameter width{"width", "m", 0, 1e3, true, "width of the flat core of the bag"};
  static constexpr Parameter height{"half_height", "m", 0, 1e3, true, "half of the bag's height, radius of its sides"};
  static constexpr Parameter corner{"corner_radius", "m", 0, 1e3, false, "radius of the core's corners"};
  Pillow p;
  p.width = table.number(width, p.width);
  p.half_height = table.number(height, p.half_height);
  p.corner_radius = table.number(corner, p.corner_radius);
  if (2 * p.corner_radius > p.width) table.mistake("corner_radius", "is more than half the width: round the core less");
  return p;
}

double Pillow::depth(const Vec3& point) const {
  const double c = 0.5 * width - corner_radius;
  const double x = std::max(std::abs(point.x()) - c, 0.0), y = std::max(std::abs(point.y()) - c, 0.0);
  const double beyond = std::max(0.0, std::hypot(x, y) - corner_radius);
  return half_height - std::hypot(beyond, point.z());
}

double Pillow::volume(double depth) const {
  const double h = half_height - depth, r = corner_radius;
  const double area = width * width - (4 - pi) * r * r, perimeter = 4 * width - (8 - 2 * pi) * r;
  return 2 * h * area + 0.5 * pi * h * h * perimeter + 4.0 / 3.0 * pi * h * h * h;
}

std::vector<Vec3> Pillow::spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                                 bool even) const {
  const double arc = 0.5 * pi * (half_height + outside);
  std::vector<Vec3> points;
  for (const Vec3& b : box)
    points.push_back(at(b, even ? cells[2] / (cells_across(b, cells) + cells[2]) : arc / (0.5 * width + arc), outside));
  return points;
}

Vec3 Pillow::at(const Vec3& box, double side, double outside) const {
  const double radius = half_height + outside;
  const double half_hoop = 0.5 * width + 0.5 * pi * radius;  // from the middle of the top to the middle of a side
  const bool top = std::abs(box.z()) >= 1;
  const double ring = std::max(std::abs(box.x()), std::abs(box.y()));
  const double from_side = side * half_hoop;
  const double s = top ? ring * (half_hoop - from_side) : half_hoop - std::abs(box.z()) * from_side;
  const double up = box.z() < 0 ? -1 : 1;
  if (s <= 0.5 * width) {
    // The corners of the rings round gradually, so that the middle of the face is a regular grid.
    const double share = s / (0.5 * width);
    const auto xy = on_outline(box.x(), box.y(), s, corner_radius * share * share);
    return {xy.x(), xy.y(), up * radius};
  }
  const double angle = (s - 0.5 * width) / radius, beyond = radius * std::sin(angle);
  const auto xy = on_outline(box.x(), box.y(), 0.5 * width + beyond, corner_radius + beyond);
  return {xy.x(), xy.y(), box.z() == 0 ? 0.0 : up * radius * std::cos(angle)};
}

Vec3 Pillow::nearest(const Vec3& point, double outside) const {
  const double c = 0.5 * width - corner_radius;
  const Eigen::Array2d from_middle = point.head<2>().array().abs();
  Eigen::Array2d core = from_middle.min(c);
  const Eigen::Vector2d beyond = (from_middle - core).matrix();
  const double reach = beyond.norm();
  core += reach > corner_radius ? Eigen::Array2d(beyond.array() * (corner_radius / reach)) : beyond.array();
  const Vec3 foot(std::copysign(core[0], point.x()), std::copysign(core[1], point.y()), 0);
  return foot + (point - foot).normalized() * (half_height + outside);
}

std::vector<Vec3> Box::spread(const std::vector<Vec3>& box, const std::array<int, 3>&, double outside, bool) const {
  std::vector<Vec3> points;
  for (const Vec3& b : box) {
    const Vec3 out = Vec3((b.array().abs() >= 1).select(b, Vec3::Zero())).normalized();
    points.emplace_back(0.5 * (lower + upper) + 0.5 * b.cwiseProduct(upper - lower) + outside * out);
  }
  return points;
}

Vec3 Box::nearest(const Vec3& point, double outside) const {
  const Vec3 foot = point.cwiseMax(lower).cwiseMin(upper);
  const Vec3 beyond = point - foot;
  if (const double distance = beyond.norm(); distance > 0) return foot + outside / distance * beyond;
  Vec3 moved = point;
  const Vec3 below = point - lower, above = upper - point;
  Eigen::Index a = 0;
  if (below.cwiseMin(above).minCoeff(&a); below[a] < above[a])
    moved[a] = lower[a] - outside;
  else
    moved[a] = upper[a] + outside;
  return moved;
}

}  // namespace soilweave::packing
