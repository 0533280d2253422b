// Masses with which grains of any size admit the same time step.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A grain of mass m admits a step of sqrt(2 m/k). The stiffness k of a Hertzian contact grows as the radius, the mass
// as its cube, so small grains bound the step. In quasi-static motion masses do not change where grains come to rest.
// Masses in proportion to the stiffness, at equal relative overlap, use each step best.
// Their sum stays, and thus nearly the speed of waves.
#pragma once

#include "dem/contact/model.h"
#include "files/records.h"

namespace soilweave::dem {

/// Gives the grains masses in proportion to the normal stiffness between equal grains; their sum stays.
/// The stiffness is at the reference overlap (step_bound.h). Scaling again changes nothing.
void equalise_steps(const Model& model, io::GrainsRecord& grains);

}  // namespace soilweave::dem
