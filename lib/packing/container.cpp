// The bag of the thesis, and an upright box.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container.h"

#include <fmt/format.h>

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
  static constexpr Parameter width{"width", "m", 0, 1e3, true, "width of the bag's flat faces"};
  static constexpr Parameter height{"half_height", "m", 0, 1e3, true, "half of the bag's height"};
  static constexpr Parameter corner{"corner_radius", "m", 0, 1e3, false, "radius of the faces' corners"};
  static constexpr Parameter sides{"side_radius", "m", 0, 1e3, true, "radius of the sides; half_height if not given"};
  Pillow p;
  p.width = table.number(width, p.width);
  p.half_height = table.number(height, p.half_height);
  p.corner_radius = table.number(corner, p.corner_radius);
  p.side_radius = table.number(sides, p.half_height);
  if (2 * p.corner_radius > p.width)
    table.mistake("corner_radius", "is more than half the width: round the faces less");
  if (p.side_radius < p.half_height) table.mistake("side_radius", "is less than half_height: give half_height or more");
  if (2 * p.overhang() > p.width)
    table.mistake("side_radius", "is so large that the sides cut each other: give less");
  else if (p.corner_radius < p.overhang())
    table.mistake("corner_radius",
                  fmt::format("is less than {:.4g} m, by which the faces reach beyond the middles of such "
                              "round sides: round the faces more",
                              p.overhang()));
  return p;
}

double Pillow::overhang() const { return std::sqrt(side_radius * side_radius - half_height * half_height); }

double Pillow::first_angle() const { return std::acos(half_height / side_radius); }

double Pillow::half_hoop(double outside) const {
  const double first = first_angle();
  return 0.5 * width + first * outside + (0.5 * pi - first) * (side_radius + outside);
}

Vec3 Pillow::high() const {
  const double reach = 0.5 * width - overhang() + side_radius;
  return {reach, reach, half_height};
}

Vec3 Pillow::foot(const Vec3& point) const {
  const double r = corner_radius - overhang(), c = 0.5 * width - corner_radius;
  const Eigen::Array2d from_middle = point.head<2>().array().abs();
  Eigen::Array2d core = from_middle.min(c);
  const Eigen::Vector2d beyond = (from_middle - core).matrix();
  const double reach = beyond.norm();
  core += reach > r ? Eigen::Array2d(beyond.array() * (r / reach)) : beyond.array();
  return {std::copysign(core[0], point.x()), std::copysign(core[1], point.y()), 0};
}

double Pillow::depth(const Vec3& point) const {
  const Vec3 from_core = point - foot(point);
  const double out = from_core.head<2>().norm(), up = std::abs(point.z()), seam = overhang();
  const double below_face = half_height - up, inside_sides = side_radius - from_core.norm();
  if (below_face < 0 && out > seam && out * half_height < up * seam) return -std::hypot(out - seam, up - half_height);
  return std::min(below_face, inside_sides);
}

double Pillow::volume(double depth) const {
  const double h = half_height - depth, s = side_radius - depth;
  const double w = width - 2 * overhang(), r = corner_radius - overhang();
  const double area = w * w - (4 - pi) * r * r, perimeter = 4 * w - (8 - 2 * pi) * r;
  const double round = std::asin(std::min(h / s, 1.0));
  return 2 * h * area + perimeter * (h * std::sqrt(std::max(s * s - h * h, 0.0)) + s * s * round) +
         2 * pi * h * (s * s - h * h / 3);
}

std::vector<Vec3> Pillow::spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                                 bool even) const {
  const double round = 1 - 0.5 * width / half_hoop(outside);
  std::vector<Vec3> points;
  for (const Vec3& b : box)
    points.push_back(at(b, even ? cells[2] / (cells_across(b, cells) + cells[2]) : round, outside));
  return points;
}

Vec3 Pillow::at(const Vec3& box, double side, double outside) const {
  const double hoop = half_hoop(outside);
  const bool top = std::abs(box.z()) >= 1;
  const double ring = std::max(std::abs(box.x()), std::abs(box.y()));
  const double from_side = side * hoop;
  const double s = top ? ring * (hoop - from_side) : hoop - std::abs(box.z()) * from_side;
  const double up = box.z() < 0 ? -1 : 1;
  if (s <= 0.5 * width) {
    // The corners of the rings round gradually, so that the middle of the face is a regular grid.
    const double share = s / (0.5 * width);
    const auto xy = on_outline(box.x(), box.y(), s, corner_radius * share * share);
    return {xy.x(), xy.y(), up * (half_height + outside)};
  }
  // Around the edge of the face, then around the side.
  const double edge = first_angle() * outside, way = s - 0.5 * width;
  const bool on_edge = way < edge;
  const double angle = on_edge ? way / outside : first_angle() + (way - edge) / (side_radius + outside);
  const double radius = on_edge ? outside : side_radius + outside;
  const double beyond = radius * std::sin(angle) - (on_edge ? 0 : overhang());
  const double height = radius * std::cos(angle) + (on_edge ? half_height : 0);
  const auto xy = on_outline(box.x(), box.y(), 0.5 * width + beyond, corner_radius + beyond);
  return {xy.x(), xy.y(), box.z() == 0 ? 0.0 : up * height};
}

Vec3 Pillow::nearest(const Vec3& point, double outside) const {
  const Vec3 core = foot(point), from_core = point - core;
  const double out = from_core.head<2>().norm(), up = std::abs(point.z()), seam = overhang();
  const double over = std::copysign(1.0, point.z());
  if (out <= seam && seam > 0) return {point.x(), point.y(), over * (half_height + outside)};
  if (out * half_height >= up * seam) return core + from_core.normalized() * (side_radius + outside);
  const Vec3 edge = core + Vec3(from_core.x() * seam / out, from_core.y() * seam / out, over * half_height);
  return edge + (point - edge).normalized() * outside;
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
