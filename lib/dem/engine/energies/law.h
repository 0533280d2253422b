// The energy taken or created by the incremental contact law.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energies/frictional.h"
#include "dem/engine/energies/rolling_plastic.h"
#include "dem/engine/energies/tangential_work.h"

namespace soilweave::dem::energies {

/// The work on the tangential springs minus their dissipated and their stored energy. An incremental law does not close
/// this balance.
struct Law {
  static constexpr std::string_view name = "law";
  static constexpr std::string_view column = "law_energy";
  static constexpr std::string_view sentence =
      "energy taken out (+) or created (-) by the incremental contact law itself";
  static constexpr EnergyRole role = EnergyRole::numerical;
  static constexpr int place = 80;
  static double now(const AssemblyState& state, const Energies& e) {
    return e[TangentialWork::name] - e[Frictional::name] - e[RollingPlastic::name] - state.in_contacts.tangential();
  }
};

}  // namespace soilweave::dem::energies
