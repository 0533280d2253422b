// The work on the contacts' tangential springs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The work of slip, rolling and twisting on their springs. The term in law.h is this work minus its stored and
/// dissipated parts.
struct TangentialWork {
  static constexpr std::string_view name = "tangential_work";
  static constexpr std::string_view column = "";
  static constexpr std::string_view sentence =
      "work on the shear, rolling and twisting springs, and their energy at the start";
  static constexpr EnergyRole role = EnergyRole::internal;
  static constexpr int place = 30;
  static double at_start(const AssemblyState& state) { return state.in_contacts.tangential(); }
  static double in_step(const StepWork& step) { return step.contacts.tangential_work; }
  static double between_steps(const Intervention& change) { return change.numerical; }
};

}  // namespace soilweave::dem::energies
