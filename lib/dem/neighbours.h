// Which pairs may touch soon: a list with a skin in the deforming cell. Contacts keep their memory across rebuilds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/bodies.h"
#include "dem/cell.h"
#include "dem/contacts.h"
#include "dem/plane.h"

namespace soilweave::dem {

class Neighbours {
 public:
  /// skin: m, the gap up to which pairs are listed.
  explicit Neighbours(double skin) : skin_(skin) {}

  /// Counts how much pairs may have closed in a step: twice the fastest grain plus the affine closing of the longest
  /// branch. Returns true when the list is no longer safe.
  bool outdated(double largest_speed, const Mat3& velocity_gradient, double largest_radius, double dt);
  /// Lists all pairs of grains, and of grains and planes, closer than the skin; what `contacts` knew of them is kept.
  void rebuild(const Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts);

 private:
  double skin_;
  double closed_ = 0;  // m, since the last rebuild
};

}  // namespace soilweave::dem
