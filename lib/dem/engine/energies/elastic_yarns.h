// The energy stored in the yarns of geotextiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The energy that unloading the yarns returns (wire.h).
struct ElasticYarns {
  static constexpr std::string_view name = "elastic_yarns";
  static constexpr std::string_view column = "yarn_elastic_energy";
  static constexpr std::string_view sentence = "stored in yarns";
  static constexpr EnergyRole role = EnergyRole::stored;
  static constexpr int place = 24;
  static double now(const AssemblyState& state, const Energies&) { return state.yarns.sums().elastic; }
  static bool occurs(const AssemblyState& state) { return state.yarns.any(); }
};

}  // namespace soilweave::dem::energies
