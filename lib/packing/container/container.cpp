// The bag of the thesis, and an upright box.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/container.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "packing/container/chart.h"

namespace soilweave::packing {
using std::numbers::pi;

void FilledBag::read(Settings& table) {
  static constexpr Parameter corner{"corner_radius", "m", 0, 1e3, false, "radius of the corners, seen from above"};
  static_cast<Profile&>(*this) = Profile::read(table);
  corner_radius = table.number(corner, corner_radius);
  if (2 * corner_radius > width) table.mistake("corner_radius", "is more than half the width: round the corners less");
}

std::vector<Vec3> FilledBag::spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                                    bool even) const {
  const double round = 1 - 0.5 * width / half_hoop(outside);
  std::vector<Vec3> points;
  for (const Vec3& b : box) {
    const SurfacePoint at = surface_point(b, even ? cells[2] / (cells_across(b, cells) + cells[2]) : round, outside);
    // The corners of the rings round gradually, so that the middle of the face is a regular grid.
    const double share = at.face / (0.5 * width);
    const auto xy = on_outline(b.x(), b.y(), at.face + at.beyond, corner_radius * share * share + rounder(at.beyond));
    points.emplace_back(xy.x(), xy.y(), at.height);
  }
  return points;
}

Pillow::Pillow(Settings& table) : Pillow() {
  read(table);
  if (core() >= 0 && corner_radius < overhang())
    table.mistake("corner_radius",
                  fmt::format("is less than {:.4g} m, by which the faces reach beyond the middles of such round sides: "
                              "round the faces more, or give shape = \"cushion\", whose corners may be sharper",
                              overhang()));
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
  return Profile::depth((point - foot(point)).head<2>().norm(), point.z());
}

double Pillow::volume(double depth) const {
  const double h = half_height - depth, s = side_radius - depth;
  const double w = width - 2 * overhang(), r = corner_radius - overhang();
  const double area = w * w - (4 - pi) * r * r, perimeter = 4 * w - (8 - 2 * pi) * r;
  const double round = std::asin(std::min(h / s, 1.0));
  return 2 * h * area + perimeter * (h * std::sqrt(std::max(s * s - h * h, 0.0)) + s * s * round) +
         2 * pi * h * (s * s - h * h / 3);
}

Vec3 Pillow::nearest(const Vec3& point, double outside) const {
  const Vec3 core = foot(point);
  const Eigen::Vector2d beyond = (point - core).head<2>();
  const double out = beyond.norm();
  const Eigen::Vector2d there = Profile::nearest(out, point.z(), outside);
  const double way = out > 0 ? there.x() / out : 0;
  return {core.x() + way * beyond.x(), core.y() + way * beyond.y(), there.y()};
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
