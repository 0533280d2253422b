// An energy term from outside the library: what a viscous fluid at rest would take from the grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The work of a drag of 0.01 N s/m on each grain, counted as if the fluid were there.
struct ToyDrag {
  static constexpr std::string_view name = "toy_drag";
  static constexpr std::string_view sentence = "taken by the drag of the toy";
  static constexpr EnergyRole role = EnergyRole::dissipated;

  static double in_step(const StepWork& step) {
    double power = 0;
    for (std::size_t i = 0; i < step.bodies.size(); ++i)
      power += 0.01 * vector_of(step.bodies.velocity(i)).squaredNorm();
    return power * step.dt;
  }
};

}  // namespace soilweave::dem::energies
