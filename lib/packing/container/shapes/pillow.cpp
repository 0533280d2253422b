// The bag of the thesis.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/shapes/pillow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soilweave::packing {
using std::numbers::pi;

std::unique_ptr<Container> Pillow::read(Settings& table, PlanFiles*) {
  auto bag = std::make_unique<Pillow>();
  bag->read_section(table);
  if (bag->core() >= 0 && bag->corner_radius < bag->overhang())
    table.mistake("corner_radius",
                  fmt::format("is less than {:.4g} m, by which the faces reach beyond the middles of such round sides: "
                              "round the faces more, or give shape = \"cushion\", whose corners may be sharper",
                              bag->overhang()));
  return bag;
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

}  // namespace soilweave::packing
