// Inner values of finite elements that only tests set or read; checkpoints hold them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/archive.h"
#include "fem/material/continuum_laws.h"
#include "fem/model/soil.h"

namespace soilweave::fem::test {

/// Sets the velocities of all nodes, m/s.
inline void set_velocities(Soil& soil, const std::vector<Vec2>& velocities) {
  Archive kept;
  soil.archive(kept);
  Archive::Numbers numbers = kept.numbers();
  std::vector<double>& flat = numbers.at("soil_velocity");
  flat.clear();
  for (const Vec2& v : velocities) flat.insert(flat.end(), {v[0], v[1]});
  Archive given(std::move(numbers), "test");
  soil.archive(given);
}

/// Returns the stress of a continuum across its plane, Pa, tension positive.
inline double out_of_plane_stress(ContinuumPoint& point) {
  Archive kept;
  point.archive(kept, "");
  return kept.numbers().at("stress").at(4);  // behind the four components in the plane
}

}  // namespace soilweave::fem::test
