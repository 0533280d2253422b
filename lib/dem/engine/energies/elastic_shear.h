// The energy stored in the contacts' shear springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The shear part of the contacts' stored energy.
struct ElasticShear {
  static constexpr std::string_view name = "elastic_shear";
  static constexpr std::string_view column = "";
  static constexpr std::string_view sentence = "stored in the shear springs of the contacts";
  static constexpr EnergyRole role = EnergyRole::stored;
  static constexpr int place = 21;
  static double now(const AssemblyState& state, const Energies&) { return state.in_contacts.shear; }
};

}  // namespace soilweave::dem::energies
