// The cross-section of a filled bag: flat faces, and arcs between them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tensor.h"
#include "core/text/settings.h"

namespace soilweave::packing {

/// Section across a side: a flat face, and an arc from it to the other face. Sides with side_radius = half_height meet
/// the faces without an edge. A point has a horizontal distance outside the arc's centre, at least 0, and a height
/// above the centre, m.
struct Profile {
  double width = 0.374336;    // width of the flat faces, m; this bag is the thesis's
  double half_height = 0.04;  // m
  double side_radius = 0.04;  // radius of the sides, at least half_height, m

  /// Reads width, half_height and side_radius of a table.
  static Profile read(Settings& table);

  /// Return how far the flat faces reach beyond the arcs' centres, m, and the angle from the vertical at which arcs
  /// begin.
  double overhang() const;
  double first_angle() const;
  /// Return the distance from the axis to the arc's centre, m, and to the surface at the centre's height.
  double core() const { return 0.5 * width - overhang(); }
  double reach() const { return core() + side_radius; }
  /// Returns the length from the middle of the top to the middle of a side, on the line parallel at `outside`, m.
  double half_hoop(double outside) const;
  /// Returns the distance to the section's outline, m; negative outside.
  double depth(double out, double height) const;
  /// Returns the point of the parallel line nearest to a point near it.
  Eigen::Vector2d nearest(double out, double height, double outside) const;
  /// A point on a parallel surface.
  struct SurfacePoint {
    double face, beyond;  // distance from the axis up to the face's edge, and from there on, m
    double height;        // m
  };
  /// Returns the position on the surface parallel at `outside` of a point (u, v, w) of a box's surface, in [-1, 1].
  /// side: share of half_hoop() that the box's side covers.
  SurfacePoint surface_point(const Vec3& box, double side, double outside) const;
};

/// Returns a point of the outline, seen from above, of a square of half width `half` with corner radius r, m. (u, v):
/// the point on the outline of a square from -1 to 1. Equal steps along a side give equal lengths.
Eigen::Vector2d on_outline(double u, double v, double half, double r);

}  // namespace soilweave::packing
