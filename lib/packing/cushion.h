// A filled bag whose sides are straight from corner to corner.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "packing/container.h"

namespace soilweave::packing {

/// What both cross-sections of a filled bag enclose, carried straight along x and along y, with corners rounded alike
/// at all heights: flat square faces, and sides that are round from face to face alone. Not rounded, sides meet in
/// mitres.
struct Cushion final : FilledBag {
  Cushion() = default;
  explicit Cushion(Settings& table) { read(table); }
  double depth(const Vec3& point) const override;
  /// Squares as wide as the section at each height, less their corners; deeper ones are rounded by as much less, which
  /// is exact in the middle and near to it elsewhere.
  double volume(double depth = 0) const override;
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;

 private:
  double rounder(double) const override { return 0; }
  /// A point seen where all coordinates are positive and the first is larger than the second.
  struct Seen {
    double far, near, height;
  };
  static Seen see(const Vec3& point);
  double half_width(double height) const;
  /// From the middle of the corner's rounding, at that height.
  Eigen::Vector2d from_corner(const Seen& at, double height) const;
  /// How far beyond the outline at that height, m, as seen from above; negative within.
  double beyond(const Seen& at, double height) const;
  bool inside(const Seen& at) const;
  /// Whether a point is nearest to a corner, not to a face or a side.
  bool at_corner(const Seen& at) const;
  /// The height of the corner's point nearest to this one.
  double height_on_corner(const Seen& at) const;
};

}  // namespace soilweave::packing
