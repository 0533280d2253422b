// The energy stored in the contacts' rolling springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The rolling part of the contacts' stored energy.
struct ElasticRolling {
  static constexpr std::string_view name = "elastic_rolling";
  static constexpr std::string_view column = "";
  static constexpr std::string_view sentence = "stored in the rolling springs of the contacts";
  static constexpr EnergyRole role = EnergyRole::stored;
  static constexpr int place = 22;
  static double now(const AssemblyState& state, const Energies&) { return state.in_contacts.rolling; }
};

}  // namespace soilweave::dem::energies
