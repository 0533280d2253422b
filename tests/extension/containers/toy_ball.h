// A container from outside the library: a ball about the origin.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "packing/container/container.h"

namespace soilweave::packing {

/// A ball.
struct ToyBall final : Container {
  static constexpr std::string_view name = "toy-ball";
  static std::unique_ptr<Container> read(Settings& table, PlanFiles*) {
    static constexpr Parameter size{"toy_radius", "m", 0, 1e3, true, "radius of the ball"};
    auto ball = std::make_unique<ToyBall>();
    ball->radius = table.number(size);
    return ball;
  }

  double radius = 1;  // m

  double depth(const Vec3& point) const override { return radius - point.norm(); }
  Vec3 low() const override { return Vec3::Constant(-radius); }
  Vec3 high() const override { return Vec3::Constant(radius); }
  double volume(double depth) const override { return 4 * std::numbers::pi / 3 * std::pow(radius - depth, 3); }
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>&, double outside,
                           bool) const override {
    std::vector<Vec3> points;
    for (const Vec3& b : box) points.push_back((radius + outside) * b.normalized());
    return points;
  }
  Vec3 nearest(const Vec3& point, double outside) const override { return (radius + outside) * point.normalized(); }
};

}  // namespace soilweave::packing
