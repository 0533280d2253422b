// Containers of soilbags for tests: the thesis's bag without stretch of its geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "packing/cushion.h"

namespace soilweave::testing {

/// Flat faces 400 mm wide, and sides whose arcs are 100 mm long between them: the hoop of the empty bag, 400 by 100 mm.
inline packing::Pillow inextensible() {
  packing::Pillow bag;
  bag.width = 0.4, bag.side_radius = 0.044205, bag.corner_radius = 0.042;
  return bag;
}

/// A bag with that section and sides straight from corner to corner. corner_radius: m, in plan.
inline packing::Cushion straight(double corner_radius) {
  packing::Cushion bag;
  static_cast<packing::Profile&>(bag) = inextensible();
  bag.corner_radius = corner_radius;
  return bag;
}

}  // namespace soilweave::testing
