// A filled bag whose sides are straight from corner to corner.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "packing/container/container.h"

namespace soilweave::packing {

/// Intersection of two cross-sections of a filled bag, extended along x and y. Corners are equally rounded at all
/// heights; without rounding the sides meet in mitres.
struct Cushion final : FilledBag {
  static constexpr std::string_view name = "cushion";
  /// Reads a cushion from [container].
  static std::unique_ptr<Container> read(Settings& table, PlanFiles*) {
    auto bag = std::make_unique<Cushion>();
    bag->read_section(table);
    return bag;
  }

  double depth(const Vec3& point) const override;
  /// Integrates squares as wide as the section, minus their corners. The result is exact at mid-height and approximate
  /// elsewhere.
  double volume(double depth = 0) const override;
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;

 private:
  double rounder(double) const override { return 0; }
  /// A point mirrored into the octant of positive coordinates, larger first.
  struct Seen {
    double far, near, height;
  };
  /// Mirrors a point into that octant.
  static Seen see(const Vec3& point);
  /// Returns half the width at a height, m.
  double half_width(double height) const;
  /// Returns the vector from the centre of the corner's rounding.
  Eigen::Vector2d from_corner(const Seen& at, double height) const;
  /// Returns the horizontal distance outside the outline at that height, m; negative inside.
  double beyond(const Seen& at, double height) const;
  /// Returns whether a point lies inside the bag.
  bool inside(const Seen& at) const;
  /// Returns whether a corner is nearest, not a face or a side.
  bool at_corner(const Seen& at) const;
  /// Returns the height of the nearest corner point.
  double height_on_corner(const Seen& at) const;
};

}  // namespace soilweave::packing
