// The cross-section of a filled bag: flat faces, and arcs between them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/settings.h"
#include "core/tensor.h"

namespace soilweave::packing {

/// Across a side: a flat face, and an arc from it to the other face; sides as round as half_height meet the faces
/// without an edge. Points are told by how far they lie outside the arc's middle, never inside it, and by their height
/// above it, m.
struct Profile {
  double width = 0.374336;    // m, of the flat faces
  double half_height = 0.04;  // m
  double side_radius = 0.04;  // m, at least half_height

  /// width, half_height and side_radius of a table.
  static Profile read(Settings& table);

  /// How far the flat faces reach beyond the arcs' middles, m, and the angle from the vertical at which arcs begin.
  double overhang() const;
  double first_angle() const;
  /// From the axis to the arc's middle, m, and to the surface at the middle's height.
  double core() const { return 0.5 * width - overhang(); }
  double reach() const { return core() + side_radius; }
  /// From the middle of the top to the middle of a side, on the line that is parallel so far outside, m.
  double half_hoop(double outside) const;
  /// Distance to the section's outline, m; negative outside.
  double depth(double out, double height) const;
  /// The point of the parallel line nearest to one near it.
  Eigen::Vector2d nearest(double out, double height, double outside) const;
  /// Where a point of a box's surface, u, v, w in [-1, 1], comes to lie on the parallel surface. side: share of the way
  /// from the middle of the top to the middle of a side that belongs to the box's side.
  struct Place {
    double face, beyond;  // m from the axis: up to the face's edge, and from there
    double height;        // m
  };
  Place place(const Vec3& box, double side, double outside) const;
};

/// A point of the outline, seen from above, of a square of that half width whose corners are rounded with radius r, m;
/// u and v name it on the square's own outline, along which a side is divided evenly.
Eigen::Vector2d on_outline(double u, double v, double half, double r);

}  // namespace soilweave::packing
