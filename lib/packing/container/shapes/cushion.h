// A filled bag whose sides are straight from corner to corner.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "packing/container/container.h"

namespace soilweave::packing {

/// The intersection of two cross-sections of a filled bag, extended straight along x and along y, with corners rounded
/// equally at all heights. It has flat square faces, and sides that are round only from face to face. Without rounding
/// the sides meet in mitres.
struct Cushion final : FilledBag {
  static constexpr std::string_view name = "cushion";
  /// Reads a cushion from [container].
  static std::unique_ptr<Container> read(Settings& table, PlanFiles*) {
    auto bag = std::make_unique<Cushion>();
    bag->read_section(table);
    return bag;
  }

  double depth(const Vec3& point) const override;
  /// Integrates squares as wide as the section at each height, minus their corners. Deeper squares have smaller corner
  /// radii; this is exact at mid-height and near to it elsewhere.
  double volume(double depth = 0) const override;
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;

 private:
  double rounder(double) const override { return 0; }
  /// A point mirrored into the octant of positive coordinates, with the first one the larger.
  struct Seen {
    double far, near, height;
  };
  /// Mirrors a point into that octant.
  static Seen see(const Vec3& point);
  /// Returns half the width of the section at a height, m.
  double half_width(double height) const;
  /// Returns the vector from the centre of the corner's rounding, at that height.
  Eigen::Vector2d from_corner(const Seen& at, double height) const;
  /// Returns the distance beyond the outline at that height, m, in the horizontal plane; negative inside.
  double beyond(const Seen& at, double height) const;
  /// Returns whether a point lies inside the bag.
  bool inside(const Seen& at) const;
  /// Returns whether a point is nearest to a corner, not to a face or a side.
  bool at_corner(const Seen& at) const;
  /// Returns the height of the corner's point nearest to this one.
  double height_on_corner(const Seen& at) const;
};

}  // namespace soilweave::packing
