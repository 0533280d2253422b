// What grains do to the rigid planes they touch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/plate.h"

namespace soilweave::dem {

std::vector<PlateLoad> plate_loads(const Contacts& contacts, const Bodies& bodies, const Planes& planes) {
  std::vector<PlateLoad> loads(planes.all.size());
  for (const PlanePair& pair : contacts.planes) {
    const History& h = pair.history;
    if (!h.touching) continue;
    const auto i = static_cast<std::size_t>(pair.grain), p = static_cast<std::size_t>(pair.plane);
    const Plane& plane = planes.all[p];
    const double overlap = bodies.radius(i) - (vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal);
    PlateLoad& load = loads[p];
    load.force += to_eigen(h.normal_force * pair.normal + h.memory.shear);
    // The tangent of Hertz's law; a linear contact has two thirds of it.
    if (overlap > 0) load.stiffness += 1.5 * h.normal_force / overlap;
    ++load.contacts;
  }
  return loads;
}

}  // namespace soilweave::dem
