// Forecast of a compaction before its first step: overlap of the grains, and time until a cloud closes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/model.h"
#include "dem/engine/simulation.h"
#include "packing/generate/generate.h"

namespace soilweave::packing {

/// Returns the expected mean overlap over the radius, for grains of the first material and of this radius (m) under an
/// isotropic pressure (Pa; 2D: N/m). The force f of a contact follows from p = Z (1 - n) f/(4 pi r^2) for spheres, p =
/// Z (1 - n) f/(2 pi r) for disks: Love-Weber's sum over Z/2 contacts per grain with branches 2 r. With Z (1 - n) = 3
/// (spheres: 5 contacts at a porosity of 0.4) the law gives the overlap that bears f.
double expected_overlap(const dem::Model& model, double radius, double pressure, int dimension);

/// Returns the pressure at which that overlap is `overlap` radii, Pa.
double pressure_at_overlap(const dem::Model& model, double radius, double overlap, int dimension);

/// Throws DataError if the deepest overlap, about twice the expected mean, exceeds `largest` radii. The guard of the
/// run would find that much later. Also throws it if loose grains need more than half of Recipe::largest_stage to meet.
void demand_feasible(const dem::Simulation& cloud, const dem::Model& model, const Recipe& recipe, double mean_radius,
                     int dimension, double largest);

}  // namespace soilweave::packing
