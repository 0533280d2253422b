// The elastic energy of the contacts, one column of the series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/engine/energies/elastic_normal.h"
#include "dem/engine/energies/elastic_rolling.h"
#include "dem/engine/energies/elastic_shear.h"
#include "dem/engine/energies/elastic_twisting.h"
#include "dem/engine/energies/elastic_yarns.h"

namespace soilweave::dem::energies {

/// The energy stored in all springs of the contacts.
struct ElasticContacts {
  static constexpr std::string_view name = "elastic_contacts";
  static constexpr std::string_view column = "elastic_energy";
  static constexpr std::string_view sentence = "elastic energy of the contacts";
  static constexpr EnergyRole role = EnergyRole::stored;
  static constexpr bool share = true;
  static constexpr int place = 25;
  static double now(const AssemblyState&, const Energies& e) {
    const double in_contacts =
        e[ElasticNormal::name] + e[ElasticShear::name] + e[ElasticRolling::name] + e[ElasticTwisting::name];
    // The yarns' energy is added and subtracted, which keeps the last digits equal to those of earlier runs.
    return in_contacts + e[ElasticYarns::name] - e[ElasticYarns::name];
  }
};

}  // namespace soilweave::dem::energies
