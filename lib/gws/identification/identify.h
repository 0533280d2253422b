// Identifies the lines of the wrapped soil (thesis Figs. 5.6, 5.7, 5.10 to 5.14) from discrete-element or laboratory
// series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gws/identification/line.h"
#include "gws/solution/soil.h"

namespace soilweave::gws {

/// Result of an identification.
struct Identification {
  std::vector<Line> lines;                         // lines that the data allow, in the order of Table 5.2
  std::vector<std::vector<Increment>> increments;  // increments of each series
  std::vector<std::string> left_out;               // reason for each line that is missing
  SoilFile soil;                                   // identified constants with their scatter; all others as given
};

/// Method by which the constants are found.
enum class Method {
  path,   // all at once along the paths of the bags: the plastic strain is subtracted from the compression line
  thesis  // line by line, each with the other constants as `soil` has them; the compression line takes all strain
};

/// Returns one sentence that says which strain the compression line was fitted to, and how.
std::string_view explained(Method method);

/// Identifies the lines that the series allow. `compression` and `failure` (empty: none): points of their lines from
/// other tests. M, p_a, m and Poisson's ratio are not identified: M and p_c are one constant together, m and nu are
/// taken as the thesis takes them. Series that do not begin at rest are points of the near-failure line alone.
/// `difference`: of the increments that are tabulated, and (Method::thesis) fitted. No point is dropped.
Identification identify(const std::vector<BagSeries>& series, const SoilFile& soil, const Points& compression,
                        const Points& failure, Difference difference, Method method);

}  // namespace soilweave::gws
