// The lines of the wrapped soil from one fit along the paths of all bags: the plastic strain is subtracted from the
// compression line, and no line needs the constants of another one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "gws/identification/line.h"

namespace soilweave::gws {

/// Returns the compression line (unless `compression_known`: then C_t and p_0 are those of `start`), the near-failure
/// line, the dilatancy line and the stiffness, fitted by fit_paths(). `start`: the constants known already, and where
/// the search begins. Why the stiffness is not among them is added to `left_out`. Throws DataError as fit_paths() does.
std::vector<Line> path_lines(const std::vector<BagSeries>& series, const Soil& start, bool compression_known,
                             Difference difference, std::vector<std::string>& left_out);

}  // namespace soilweave::gws
