// Closed surfaces of any shape divided like a box, so that a woven geotextile can be laid on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/tensor.h"

namespace soilweave::packing {

/// Returns the number of cells of a box's face that a line crosses from side to side through its middle and this point
/// of the surface. At a corner it is the mean of cells[0] and cells[1].
double cells_across(const Vec3& box, const std::array<int, 3>& cells);

/// A surface that is star-shaped about its middle. Top and bottom are poles. Sections from pole to pole, all around,
/// are divided by their length; so is the equator between the four corners of the box around it.
class Chart {
 public:
  /// reach: distance from the middle to the surface along a unit vector, m. half: half the extents of the box, m.
  Chart(const Vec3& middle, const Vec3& half, const std::function<double(const Vec3&)>& reach);

  /// Returns the point for u, v, w in [-1, 1], at least one of which is -1 or 1, on the surface of a box of so many
  /// cells.
  Vec3 at(const Vec3& box, const std::array<int, 3>& cells) const;

 private:
  /// Position between an entry of a row and the next: index of the first, and fraction of the way.
  struct RowPosition {
    std::size_t first;
    double part;
  };
  /// A line of points, with the length up to each.
  struct Line {
    std::vector<Vec3> points;
    std::vector<double> lengths;
    void add(const Vec3& point);
    RowPosition at_share(double share) const;  // share of its length
    Vec3 point(const RowPosition& place) const;
  };
  static RowPosition section(double azimuth);  // the two sections around an azimuth
  /// Returns the azimuth of a point of the box's outline, rad.
  double azimuth(double u, double v) const;
  double along_equator(double azimuth) const;
  /// Returns the point at a share of the section at an azimuth.
  Vec3 at(double azimuth, double share) const;

  std::vector<Line> sections_;  // lines from the upper pole to the lower, at equal azimuths
  Line equator_;                // closed, starting at azimuth 0
  double corner_;               // azimuth of the box's corner, rad
};

}  // namespace soilweave::packing
