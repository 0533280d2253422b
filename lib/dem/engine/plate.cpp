// Loads of the grains on the rigid planes that they touch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/plate.h"

#include <bit>

namespace soilweave::dem {

std::vector<PlateLoad> plate_loads(const Contacts& contacts, const Bodies& bodies, const Planes& planes) {
  std::vector<PlateLoad> loads(planes.all.size());
  for (const PlaneBlock& block : contacts.planes.blocks()) {
    const ContactBlock& pairs = block.pairs;
    const auto p = static_cast<std::size_t>(block.plane);
    const Plane& plane = planes.all[p];
    PlateLoad& load = loads[p];
    for (unsigned left = pairs.touching; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      const auto i = static_cast<std::size_t>(ContactBlock::index(pairs.first[k]));
      const double overlap = bodies.radius(i) - (vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal);
      const double normal_force = pairs.normal_force[k];
      load.force += Vec3(pairs.shear[0][k], pairs.shear[1][k], pairs.shear[2][k]) - normal_force * plane.normal;
      // This is the tangent of Hertz's law; the tangent of a linear contact is two thirds of it.
      if (overlap > 0) load.stiffness += 1.5 * normal_force / overlap;
      ++load.contacts;
    }
  }
  return loads;
}

}  // namespace soilweave::dem
