// Lines of the wrapped soil from one fit along the paths of all bags.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "gws/identification/line.h"

namespace soilweave::gws {

/// Returns the lines fitted by fit_paths(): compression (unless `compression_known`), near-failure, dilatancy and
/// stiffness. start: known constants and first guess. left_out: receives why the stiffness is missing. Throws DataError
/// as fit_paths() does.
std::vector<Line> path_lines(const std::vector<BagSeries>& series, const Soil& start, bool compression_known,
                             Difference difference, std::vector<std::string>& left_out);

}  // namespace soilweave::gws
