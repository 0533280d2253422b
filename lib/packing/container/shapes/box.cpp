// An upright box.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/shapes/box.h"

#include <cmath>

namespace soilweave::packing {

std::unique_ptr<Container> Box::read(Settings& table, PlanFiles*) {
  static constexpr Parameter low{"low", "m", -1e3, 1e3, false, "lower corner of a box"};
  static constexpr Parameter high{"high", "m", -1e3, 1e3, false, "upper corner of a box"};
  auto box = std::make_unique<Box>();
  box->lower = table.vector(low), box->upper = table.vector(high);
  if (!((box->upper - box->lower).minCoeff() > 0)) table.mistake("high", "is not above low");
  return box;
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
