// Secant stiffness of a geotextile with a curve, at the strain that is reached.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Returns the bag with the secant stiffness at a hoop strain.
Case with_secant(Case bag, double strain);

/// Returns the bag with the secant stiffness at its hoop strain under `surcharge`, or at its limit: the curve's end or
/// stated fraction of the strength. Returns a bag without a curve unchanged. Throws DataError as Response does.
Case at_strain_reached(const Case& bag, std::optional<double> surcharge);

/// Returns the first state and n states at equal steps of hoop strain, up to that of the secant. Each has the secant
/// stiffness at its own strain. Steps that end before the first state are left out.
std::vector<Point> secant_points(const Case& bag, std::size_t n);

}  // namespace soilweave::gws
