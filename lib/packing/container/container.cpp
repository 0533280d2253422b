// Filled bags.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/container.h"

#include <cmath>

#include "packing/container/chart.h"

namespace soilweave::packing {

void FilledBag::read_section(Settings& table) {
  static constexpr Parameter corner{"corner_radius", "m", 0, 1e3, false, "radius of the corners, seen from above"};
  static_cast<Profile&>(*this) = Profile::read(table);
  corner_radius = table.number(corner, 0.0);
  if (2 * corner_radius > width) table.mistake("corner_radius", "is more than half the width: round the corners less");
}

std::vector<Vec3> FilledBag::spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                                    bool even) const {
  const double round = 1 - 0.5 * width / half_hoop(outside);
  std::vector<Vec3> points;
  for (const Vec3& b : box) {
    const SurfacePoint at = surface_point(b, even ? cells[2] / (cells_across(b, cells) + cells[2]) : round, outside);
    // The corners of the rings round gradually, so that the middle of the face is a regular grid.
    const double share = at.face / (0.5 * width);
    const auto xy = on_outline(b.x(), b.y(), at.face + at.beyond, corner_radius * share * share + rounder(at.beyond));
    points.emplace_back(xy.x(), xy.y(), at.height);
  }
  return points;
}

}  // namespace soilweave::packing
