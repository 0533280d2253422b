// Scenarios of the thesis's sand for tests, from the text of their stages.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "dem/run/scenario.h"

namespace soilweave::support {

/// The contacts of thesis Table 3.1, as sand() has them (assemblies.h).
inline const std::string sand_toml =
    "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = \"4 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 29\n"
    "[contact.rolling]\nstiffness = 0.13\nlimit = \"none\"\n[contact.twisting]\nstiffness = 0.13\nlimit = \"none\"\n";

/// Returns the scenario of these stages; `before` stands above the contacts.
inline dem::Scenario scenario(const std::string& stages, const std::string& before = "") {
  return dem::read_scenario(before + sand_toml + stages, "test.toml", {});
}

}  // namespace soilweave::support
