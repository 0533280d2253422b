// The energy stored in the contacts' twisting springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The twisting part of the contacts' stored energy.
struct ElasticTwisting {
  static constexpr std::string_view name = "elastic_twisting";
  static constexpr std::string_view column = "";
  static constexpr std::string_view sentence = "stored in the twisting springs of the contacts";
  static constexpr EnergyRole role = EnergyRole::stored;
  static constexpr int place = 23;
  static double now(const AssemblyState& state, const Energies&) { return state.in_contacts.twisting; }
};

}  // namespace soilweave::dem::energies
