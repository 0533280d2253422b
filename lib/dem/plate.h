// What grains do to the rigid planes they touch.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/bodies.h"
#include "dem/contacts.h"
#include "dem/plane.h"

namespace soilweave::dem {

struct PlateLoad {
  Vec3 force = Vec3::Zero();  // N, of the grains on the plane
  double stiffness = 0;       // N/m, of all its contacts along the normal, at least
  std::size_t contacts = 0;
};

/// One entry a plane, from the last sweep.
std::vector<PlateLoad> plate_loads(const Contacts& contacts, const Bodies& bodies, const Planes& planes);

}  // namespace soilweave::dem
