// Factors that a design office brings: reduction of the strength, partial factors on load and soil. None is a default.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/cli/tool.h"
#include "gws/solution/respond.h"

namespace soilweave::gws {

struct Factors {
  double creep = 1, installation = 1, durability = 1;  // divide the strength (ISO/TS 20432)
  double load = 1;                                     // multiplies the surcharge that must not bring failure
  double soil = 1;                                     // divides tan phi in the check of failure

  void declare(tool::Table& table);
  double reduction() const { return creep * installation * durability; }
  /// Returns the soil whose tan phi, from M by sin phi = 3 M/(6 + M), is divided by the factor; none if that is 1. The
  /// failure line is lowered as a whole.
  std::optional<Soil> weakened(const Soil& soil) const;
};

/// Returns what an answer rests on, a sentence a line: the fraction of the strength that counts and where its default
/// comes from, the factors other than 1, and Matsuoka and Liu's closed form with the same tension. `unreduced`:
/// strength before its reduction, N/m. `chosen`: the fraction was given.
std::string conditions(const Case& bag, const Factors& factors, double unreduced, bool chosen);

}  // namespace soilweave::gws
