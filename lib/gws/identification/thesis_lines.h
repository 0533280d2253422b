// Lines of the wrapped soil, each fitted alone as in the thesis (Figs. 5.6, 5.7, 5.10 to 5.14).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "gws/identification/line.h"

namespace soilweave::gws {

/// Return the fitted lines; throw DataError if points do not determine them. Other constants are those of `soil`. The
/// compression line takes all strain while the soil contracts. points: results of another test; compression_line()
/// takes them instead of the series.
///
/// Fits need equal errors, so ratios are not fitted. The dilatancy line fits increments of plastic volumetric strain.
/// Young's modulus fits accumulated plastic axial strain over accumulated p*.
Line compression_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points);
Line failure_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points);
Line near_failure_line(const std::vector<BagSeries>& series, const Soil& soil);
Line dilatancy_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference);
Line stiffness_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference);

/// Returns Young's modulus of one bag, Pa. Throws DataError if plastic strain does not grow with stress.
double young_modulus(const BagSeries& series, const Soil& soil, Difference difference);

/// Returns the number of first rows that contract: the slope of eps_v over (p/p_a)^m exceeds half of the steepest slope
/// before.
std::size_t contraction(const BagSeries& series, const Soil& soil);

}  // namespace soilweave::gws
