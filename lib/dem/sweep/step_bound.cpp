// Bound on the time step from contacts that do not exist yet.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/step_bound.h"

#include <algorithm>
#include <cmath>

namespace soilweave::dem {

StepBound bound_to_come(const ContactSweep& sweep, const Bodies& bodies, const Smallest& smallest) {
  const auto materials = 1 + *std::max_element(bodies.material.begin(), bodies.material.end());
  const double r = smallest.radius;
  const PairStiffness k = sweep.stiffness(r, reference_overlap * r, materials, bodies.dimension);
  const double xi = std::sqrt(2.0) * k.damping_ratio;
  return {std::sqrt(2.0 * smallest.mass / (4.0 * k.normal)), std::sqrt(2.0 * smallest.inertia / k.rotational),
          std::sqrt(1 + xi * xi) - xi};
}

}  // namespace soilweave::dem
