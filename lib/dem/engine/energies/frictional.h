// The energy dissipated by sliding at the contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The energy that the Coulomb limit takes from the shear springs.
struct Frictional {
  static constexpr std::string_view name = "frictional";
  static constexpr std::string_view column = "frictional_dissipation";
  static constexpr std::string_view sentence = "dissipated by sliding";
  static constexpr EnergyRole role = EnergyRole::dissipated;
  static constexpr int place = 50;
  static double in_step(const StepWork& step) { return step.contacts.frictional; }
};

}  // namespace soilweave::dem::energies
