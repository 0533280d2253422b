// The work of gravity on the grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energy_term.h"

namespace soilweave::dem::energies {

/// The work of gravity.
struct GravityWork {
  static constexpr std::string_view name = "gravity_work";
  static constexpr std::string_view sentence = "work of gravity";
  static constexpr EnergyRole role = EnergyRole::supplied;
  static constexpr int place = 60;
  static double in_step(const StepWork& step) { return step.grains.gravity_work; }
};

}  // namespace soilweave::dem::energies
