// The kinetic energy of the grains' fluctuation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The kinetic energy, with velocities advanced to the time of the positions.
struct Kinetic {
  static constexpr std::string_view name = "kinetic";
  static constexpr std::string_view column = "kinetic_energy";
  static constexpr std::string_view sentence = "kinetic energy of the fluctuation";
  static constexpr EnergyRole role = EnergyRole::kinetic;
  static constexpr int place = 10;
  static double now(const AssemblyState& state, const Energies&) {
    return kinetic_energy(state.bodies, state.gravity, state.dt, state.threads);
  }
};

}  // namespace soilweave::dem::energies
