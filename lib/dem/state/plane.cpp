// Rigid planes as contact partners.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/state/plane.h"

#include <algorithm>
#include <cmath>

namespace soilweave::dem {
namespace {

// Returns a unit vector unchanged: repeated normalisation would change its last bits.
Vec3 unit(const Vec3& v) {
  constexpr double rounding = 1e-15;
  return std::abs(v.squaredNorm() - 1) <= rounding ? v : v.normalized();
}

}  // namespace

Planes::Planes(const io::PlanesRecord& record) {
  for (std::size_t k = 0; k < record.point.size(); ++k)
    all.push_back({record.point[k], unit(record.normal[k]), record.velocity[k], record.material_id[k],
                   record.partners.empty() ? Partners::all : static_cast<Partners>(record.partners[k])});
}

io::PlanesRecord Planes::record() const {
  io::PlanesRecord record;
  for (const Plane& p : all) {
    record.point.push_back(p.point);
    record.normal.push_back(p.normal);
    record.velocity.push_back(p.velocity);
    record.material_id.push_back(p.material);
    record.partners.push_back(static_cast<std::int32_t>(p.partners));
  }
  if (std::all_of(all.begin(), all.end(), [](const Plane& p) { return p.partners == Partners::all; }))
    record.partners.clear();
  return record;
}

}  // namespace soilweave::dem
