// Loads of the grains on rigid planes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"
#include "dem/state/plane.h"

namespace soilweave::dem {

/// Load on one plane.
struct PlateLoad {
  /// Force of the grains on the plane, N.
  Vec3 force = Vec3::Zero();
  /// Lower bound of the stiffness of its contacts along the normal, N/m.
  double stiffness = 0;
  /// Number of contacts.
  std::size_t contacts = 0;
};

/// Returns the load on each plane, from the last sweep.
std::vector<PlateLoad> plate_loads(const Contacts& contacts, const Bodies& bodies, const Planes& planes);

}  // namespace soilweave::dem
