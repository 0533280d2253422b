// Factors of a design office on strength, load and soil. Each is 1 by default.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/cli/tool.h"
#include "gws/solution/respond.h"

namespace soilweave::gws {

struct Factors {
  /// Divide the strength (ISO/TS 20432).
  double creep = 1, installation = 1, durability = 1;
  /// Multiplies the surcharge that must not bring failure.
  double load = 1;
  /// Divides tan phi in the check of failure.
  double soil = 1;

  /// Declares the options in a tool's table.
  void declare(tool::Table& table);
  /// Returns the factor that divides the strength.
  double reduction() const { return creep * installation * durability; }
  /// Returns the soil with tan phi divided by the factor; none if that is 1. sin phi = 3 M/(6 + M). M, kappa and
  /// xi are lowered alike, so that q/p at equal strain falls in proportion to the strength. The dilatancy line stays.
  /// Throws DataError if the factor leaves the soil no state at low stress.
  std::optional<Soil> weakened(const Soil& soil) const;
};

/// Returns the basis of an answer, one sentence a line: the fraction of the strength and its source, factors other than
/// 1, full-size runs of discrete elements beside it (beside_grains()), and Matsuoka and Liu's closed form. chosen: the
/// fraction was given.
std::string conditions(const Case& bag, const Factors& factors, bool chosen);

}  // namespace soilweave::gws
