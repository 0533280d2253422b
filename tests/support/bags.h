// Containers of soilbags for tests: the thesis's bag without stretch of its geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "packing/container/shapes/cushion.h"
#include "packing/container/shapes/pillow.h"

namespace soilweave::support {

/// Returns flat faces 400 mm wide with sides of 100 mm arcs in between: the hoop of the empty bag of 400 by 100 mm.
inline packing::Pillow inextensible() {
  packing::Pillow bag;
  bag.width = 0.4, bag.side_radius = 0.044205, bag.corner_radius = 0.042;
  return bag;
}

/// Returns a bag with that section and sides straight from corner to corner. corner_radius: m, in plan.
inline packing::Cushion straight(double corner_radius) {
  packing::Cushion bag;
  static_cast<packing::Profile&>(bag) = inextensible();
  bag.corner_radius = corner_radius;
  return bag;
}

}  // namespace soilweave::support
