// The lines of the wrapped soil, each fitted on its own as the thesis fits it (Figs. 5.6, 5.7, 5.10 to 5.14): the other
// constants are those of the soil given. The compression line is fitted to all of the strain while the soil contracts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "gws/identification/line.h"

namespace soilweave::gws {

/// Each function returns its line, fitted. They throw DataError where the points do not determine its constants.
///
/// Where the thesis plots ratios or increments, what is fitted has equal errors: the dilatancy line, increments of
/// plastic volumetric strain (a ratio of two small increments has errors of its own size); Young's modulus, the plastic
/// axial strain accumulated over the accumulated p*. `points`: of another test, instead of (compression) the series'.
Line compression_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points);
Line failure_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points);
Line near_failure_line(const std::vector<BagSeries>& series, const Soil& soil);
Line dilatancy_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference);
Line stiffness_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference);

/// Returns Young's modulus of one bag, Pa. Throws DataError where the plastic strain does not grow with the stress.
double young_modulus(const BagSeries& series, const Soil& soil, Difference difference);

/// Returns the number of rows at the start of a series that count as contraction: those where the slope of eps_v over
/// (p/p_a)^m is at least half of the steepest slope before it.
std::size_t contraction(const BagSeries& series, const Soil& soil);

}  // namespace soilweave::gws
