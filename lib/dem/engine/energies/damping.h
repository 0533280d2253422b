// The energy dissipated by local damping of the grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The energy taken by local damping, and by slowing all grains between steps.
struct Damping {
  static constexpr std::string_view name = "damping";
  static constexpr std::string_view column = "damping_dissipation";
  static constexpr std::string_view sentence = "dissipated by local damping";
  static constexpr EnergyRole role = EnergyRole::dissipated;
  static constexpr int place = 53;
  static double in_step(const StepWork& step) { return step.grains.damping; }
  static double between_steps(const Intervention& change) { return change.damped; }
};

}  // namespace soilweave::dem::energies
