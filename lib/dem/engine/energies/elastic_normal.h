// The energy stored in the contacts' normal springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The normal part of the contacts' stored energy, adhesion included.
struct ElasticNormal {
  static constexpr std::string_view name = "elastic_normal";
  static constexpr std::string_view column = "";
  static constexpr std::string_view sentence = "stored in the normal springs of the contacts";
  static constexpr EnergyRole role = EnergyRole::stored;
  static constexpr int place = 20;
  static double now(const AssemblyState& state, const Energies&) { return state.in_contacts.normal; }
};

}  // namespace soilweave::dem::energies
