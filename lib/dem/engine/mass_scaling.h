// Masses with which grains of any size admit the same time step.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A grain of mass m admits a step of sqrt(2 m/k). The stiffness k of a Hertzian contact grows as the radius, the mass
// as its cube, so small grains bound the step. In quasi-static motion the masses do not affect where grains come to
// rest. If masses are proportional to the stiffness at equal relative overlap, all grains admit the same step.
// The total mass is unchanged, so the speed of waves is nearly unchanged.
#pragma once

#include "dem/contact/model.h"
#include "files/records.h"

namespace soilweave::dem {

/// Makes the masses proportional to the normal stiffness between equal grains, and keeps their sum.
/// The stiffness is taken at the reference overlap (step_bound.h). Scaling twice equals scaling once.
void equalise_steps(const Model& model, io::GrainsRecord& grains);

}  // namespace soilweave::dem
