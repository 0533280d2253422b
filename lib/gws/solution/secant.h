// A geotextile by its curve: the solution has one stiffness, so it takes the secant at the strain that is reached.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Returns the bag with the secant stiffness at a hoop strain.
Case with_secant(Case bag, double strain);

/// Returns the bag with the secant stiffness at the hoop strain that it reaches under `surcharge`, or at its limit:
/// where the curve has the stated fraction of the strength, or fails. A bag without a curve is returned as it is.
/// Throws DataError as Response does.
Case at_strain_reached(const Case& bag, std::optional<double> surcharge);

/// Returns n states at equal steps of hoop strain up to that of the bag's secant, each with the secant stiffness at its
/// own strain, after the state at the beginning. Steps that end before the beginning are left out.
std::vector<Point> secant_points(const Case& bag, std::size_t n);

}  // namespace soilweave::gws
