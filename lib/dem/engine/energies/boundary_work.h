// The work of the deforming cell, of moving planes and of clamps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The work of the boundaries. The work of the cell takes the mean of the stress before and after the step.
struct BoundaryWork {
  static constexpr std::string_view name = "boundary_work";
  static constexpr std::string_view sentence = "work done on the grains by the cell and moving planes";
  static constexpr EnergyRole role = EnergyRole::supplied;
  static constexpr int place = 40;
  static double in_step(const StepWork& step) {
    const Mat3 both = step.before.force_branch + step.contacts.force_branch;
    return step.contacts.plane_work + step.clamps - 0.5 * step.dt * both.cwiseProduct(step.velocity_gradient).sum();
  }
  static double between_steps(const Intervention& change) { return change.supplied; }
};

}  // namespace soilweave::dem::energies
