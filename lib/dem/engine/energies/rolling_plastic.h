// The energy dissipated by rolling and twisting at the contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The energy that the plastic limits take from the rolling and twisting springs.
struct RollingPlastic {
  static constexpr std::string_view name = "rolling_plastic";
  static constexpr std::string_view column = "rolling_dissipation";
  static constexpr std::string_view sentence = "dissipated at the rolling and twisting limits";
  static constexpr EnergyRole role = EnergyRole::dissipated;
  static constexpr int place = 51;
  static double in_step(const StepWork& step) { return step.contacts.rolling_plastic; }
};

}  // namespace soilweave::dem::energies
