// Masses with which grains of any size bear the same time step.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A grain of mass m bears a step of sqrt(2 m/k). The stiffness k of a Hertzian contact grows as the radius, the mass as
// its cube: small grains bound the step of all. Where motion is quasi-static the masses say only how fast waves run,
// not where the grains come to rest: in proportion to the stiffness, at the same overlap over radius, they make the
// most of each step. Their sum stays, and with it the speed of waves through the whole, nearly.
#pragma once

#include "dem/model.h"
#include "io/records.h"

namespace soilweave::dem {

/// Gives the grains masses in proportion to the normal stiffness that a contact with an equal grain has at the
/// reference overlap (step_bound.h); their sum stays what it is. Masses scaled before are scaled to the same ones.
void equalise_steps(const Model& model, io::GrainsRecord& grains);

}  // namespace soilweave::dem
