// An energy term from outside the library: the part of the kinetic energy that is rotation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The share of rotation, with spins of half a step before the positions.
struct ToyRotation {
  static constexpr std::string_view name = "toy_rotation";
  static constexpr std::string_view column = "toy_rotational_energy";
  static constexpr std::string_view sentence = "rotational part of the kinetic energy";
  static constexpr EnergyRole role = EnergyRole::kinetic;
  static constexpr bool share = true;

  static bool occurs(const AssemblyState& state) { return state.bodies.dimension == 3; }
  static double now(const AssemblyState& state, const Energies&) {
    double energy = 0;
    for (std::size_t i = 0; i < state.bodies.size(); ++i)
      if (!state.bodies.is_node(i))
        energy += 0.5 * state.bodies.inertia(i) * vector_of(state.bodies.spin(i)).squaredNorm();
    return energy;
  }
};

}  // namespace soilweave::dem::energies
