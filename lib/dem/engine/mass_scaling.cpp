// Masses with which grains of any size admit the same time step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/mass_scaling.h"

#include <algorithm>
#include <numeric>

#include "dem/sweep/contact_sweep.h"
#include "dem/sweep/step_bound.h"

namespace soilweave::dem {

void equalise_steps(const Model& model, io::GrainsRecord& grains) {
  const std::unique_ptr<ContactSweep> sweep = make_contact_sweep(model);
  const std::int32_t materials = 1 + *std::max_element(grains.material_id.begin(), grains.material_id.end());
  const double total = std::accumulate(grains.mass.begin(), grains.mass.end(), 0.0);
  double stiffness = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double r = grains.radius[i];
    grains.mass[i] = sweep->stiffness(r, reference_overlap * r, materials, grains.dimension).normal;
    stiffness += grains.mass[i];
  }
  for (double& mass : grains.mass) mass *= total / stiffness;
}

}  // namespace soilweave::dem
