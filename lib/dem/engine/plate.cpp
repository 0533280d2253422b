// Loads of the grains on the rigid planes that they touch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/plate.h"

namespace soilweave::dem {

std::vector<PlateLoad> plate_loads(const Contacts& contacts, const Bodies& bodies, const Planes& planes) {
  std::vector<PlateLoad> loads(planes.all.size());
  for (const PlaneBlock& block : contacts.planes.blocks()) {
    if (!block.pairs.touching) continue;
    const auto p = static_cast<std::size_t>(block.plane);
    const Plane& plane = planes.all[p];
    for (int k = 0; k < block.pairs.count; ++k) {
      const PairHistory h = history_of(block.pairs, k);
      if (!h.touching) continue;
      const auto i = static_cast<std::size_t>(ContactBlock::index(block.pairs.first[k]));
      const double overlap = bodies.radius(i) - (vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal);
      PlateLoad& load = loads[p];
      load.force += to_eigen(h.history.shear) - h.normal_force * plane.normal;
      // This is the tangent of Hertz's law; the tangent of a linear contact is two thirds of it.
      if (overlap > 0) load.stiffness += 1.5 * h.normal_force / overlap;
      ++load.contacts;
    }
  }
  return loads;
}

}  // namespace soilweave::dem
