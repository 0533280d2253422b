// Closed surfaces of any shape divided like a box, so that a woven geotextile can be laid on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/tensor.h"

namespace soilweave::packing {

/// How many cells of a box's face a line crosses from side to side through its middle and this point of its surface:
/// towards a corner, half of each side's.
double cells_across(const Vec3& box, const std::array<int, 3>& cells);

/// A surface that is seen whole from its middle. Its top and bottom are poles; sections from pole to pole, all around,
/// are divided by their length, and so is the equator between the four corners of the box around it.
class Chart {
 public:
  /// reach: the distance, m, from the middle to the surface along a unit vector. half: half the extents of the box, m.
  Chart(const Vec3& middle, const Vec3& half, const std::function<double(const Vec3&)>& reach);

  /// The point for u, v, w in [-1, 1], of which one at least is -1 or 1, on the surface of a box of so many cells.
  Vec3 at(const Vec3& box, const std::array<int, 3>& cells) const;

 private:
  /// Between one of a row and the next: the first of the two, and the part of the way from it.
  struct Place {
    std::size_t first;
    double part;
  };
  /// A line of points and the length up to each.
  struct Line {
    std::vector<Vec3> points;
    std::vector<double> lengths;
    void add(const Vec3& point);
    Place at_share(double share) const;  // of its length
    Vec3 point(const Place& place) const;
  };
  static Place section(double azimuth);  // the ones that an azimuth lies between
  double azimuth(double u, double v) const;
  double along_equator(double azimuth) const;
  Vec3 at(double azimuth, double share) const;

  std::vector<Line> sections_;  // from the upper pole to the lower, evenly around
  Line equator_;                // closed, from the azimuth 0
  double corner_;               // rad, azimuth of the box's corner
};

}  // namespace soilweave::packing
