// Rigid planes as contact partners.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/plane.h"

namespace soilweave::dem {

Planes::Planes(const io::PlanesRecord& record) {
  for (std::size_t k = 0; k < record.point.size(); ++k)
    all.push_back({record.point[k], record.normal[k].normalized(), record.velocity[k], record.material_id[k]});
}

io::PlanesRecord Planes::record() const {
  io::PlanesRecord record;
  for (const Plane& p : all) {
    record.point.push_back(p.point);
    record.normal.push_back(p.normal);
    record.velocity.push_back(p.velocity);
    record.material_id.push_back(p.material);
  }
  return record;
}

}  // namespace soilweave::dem
