// The energy dissipated in the yarns of geotextiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The energy that yielding and breaking yarns take.
struct YarnDissipation {
  static constexpr std::string_view name = "yarn_dissipation";
  static constexpr std::string_view sentence = "dissipated by yielding and breaking yarns";
  static constexpr EnergyRole role = EnergyRole::dissipated;
  static constexpr int place = 70;
  static double in_step(const StepWork& step) { return step.yarns.dissipated; }
  static bool occurs(const AssemblyState& state) { return state.yarns.any(); }
};

}  // namespace soilweave::dem::energies
