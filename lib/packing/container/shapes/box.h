// An upright box that holds grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "packing/container/container.h"

namespace soilweave::packing {

/// An upright box.
struct Box final : Container {
  static constexpr std::string_view name = "box";
  /// Reads a box from [container].
  static std::unique_ptr<Container> read(Settings& table, PlanFiles*);

  /// Corners, m.
  Vec3 lower, upper;

  double depth(const Vec3& point) const override { return (point - lower).cwiseMin(upper - point).minCoeff(); }
  Vec3 low() const override { return lower; }
  Vec3 high() const override { return upper; }
  double volume(double depth = 0) const override { return (upper - lower - Vec3::Constant(2 * depth)).prod(); }
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;
};

}  // namespace soilweave::packing
