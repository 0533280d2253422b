// Grains that a straining cell moves only through contacts and yarns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/apart.h"

#include "core/simd/v3.h"
#include "dem/state/bodies.h"

namespace soilweave::packing {

void keep_apart(const std::vector<std::int32_t>& grains, const Mat3& change, dem::Simulation& simulation) {
  if (grains.empty() || change.isZero(0.0)) return;
  simulation.change_velocities([&](dem::Bodies& bodies) {
    for (const std::int32_t grain : grains) {
      const auto i = static_cast<std::size_t>(grain);
      bodies.set_velocity(i, vector_of(bodies.velocity(i)) - change * vector_of(bodies.grains[i].position));
    }
  });
}

void hold(const std::vector<std::int32_t>& grains, dem::Simulation& simulation) {
  const Mat3 gradient = simulation.cell().velocity_gradient();
  simulation.change_velocities([&](dem::Bodies& bodies) {
    for (const std::int32_t grain : grains) {
      const auto i = static_cast<std::size_t>(grain);
      bodies.set_velocity(i, -gradient * vector_of(bodies.grains[i].position));
    }
  });
}

}  // namespace soilweave::packing
