// The energy dissipated by viscous damping at the contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The energy that the contacts' dashpots take.
struct Viscous {
  static constexpr std::string_view name = "viscous";
  static constexpr std::string_view column = "viscous_dissipation";
  static constexpr std::string_view sentence = "dissipated by contact damping";
  static constexpr EnergyRole role = EnergyRole::dissipated;
  static constexpr int place = 52;
  static double in_step(const StepWork& step) { return step.contacts.viscous; }
};

}  // namespace soilweave::dem::energies
