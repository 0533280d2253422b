// Which pairs may touch soon. Two lists: an outer one with a wide skin from a grid over the deforming cell, and the one
// that is swept, with a narrow skin, filtered from it. Contacts keep their memory across rebuilds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/bodies.h"
#include "dem/cell.h"
#include "dem/contacts.h"
#include "dem/plane.h"

namespace soilweave::dem {

class Neighbours {
 public:
  /// Skins (gaps up to which pairs are listed) are fractions of this radius, m.
  explicit Neighbours(double largest_radius);

  /// Counts how much pairs may have closed in a step: twice the fastest grain plus the affine closing of the longest
  /// branch. Returns true when the list is no longer safe.
  bool outdated(double largest_speed, const Mat3& velocity_gradient, double dt);
  /// Lists all pairs of grains, and of grains and planes, closer than the skin; what `contacts` knew of them is kept.
  void rebuild(const Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts);

 private:
  void search(const Bodies& bodies, const Cell& cell);

  double radius_, outer_skin_, skin_;  // m
  double closed_ = 0;                  // m, since the list was filtered
  double outer_closed_;                // m, since the grid was searched
  std::vector<Pair> outer_, listed_;   // sorted
};

}  // namespace soilweave::dem
