// Identifies the lines of the wrapped soil (thesis Figs. 5.6, 5.7, 5.10 to 5.14).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/doubts.h"
#include "gws/identification/line.h"
#include "gws/solution/soil.h"

namespace soilweave::gws {

/// Result of an identification.
struct Identification {
  /// Lines that the data allow, in the order of Table 5.2.
  std::vector<Line> lines;
  /// Increments of each series.
  std::vector<std::vector<Increment>> increments;
  /// Reason for each missing line.
  std::vector<std::string> left_out;
  /// Identified constants with scatter; all others as given.
  SoilFile soil;
  /// Doubts about the points of other tests: those of their tables, and "compression-range", where most of the points
  /// lie beyond the mean stress of the series.
  std::vector<Doubt> of_points;
};

/// Method that finds the constants.
enum class Method {
  /// All at once along the bags' paths, with the plastic strain subtracted from the compression line.
  path,
  /// Line by line, with the other constants as in `soil`. The compression line takes all strain, and the failure line
  /// has the confining pressure of tests in the place of their mean stress.
  thesis
};

/// Returns which strain the compression line was fitted to, and how, in one sentence.
std::string_view explained(Method method);

/// Identifies the lines that the series allow. A line is left out if its constants leave their ranges, or if it
/// explains its points worse than their mean does. compression, failure: points of other tests; empty: none. M, p_a, m
/// and Poisson's ratio are not identified: M and p_c together are one constant, m and nu are as in the thesis. Series
/// not from rest serve the near-failure line alone. difference: kind of the increments, which are tabulated and
/// (Method::thesis) fitted. No point is dropped.
Identification identify(const std::vector<BagSeries>& series, const SoilFile& soil, const Points& compression,
                        const Points& failure, Difference difference, Method method);

/// Returns the doubts by name. "not-identified": lines keep the constants of the soil that identification began with.
/// "exact-fit": a line has as many points as constants. "hardly-determined": a 95 % interval leaves the range of its
/// constant, or R2 is below 0.5. "out-of-proportion": C_t is more than ten times off the given soil's, or p_c more than
/// a thousand times beyond the mean stresses at failure. Those of the points and of the given soil's test follow.
/// assignments: constants that the user gave, as "failure_line.n=0"; their lines do not count as kept.
std::vector<Doubt> doubts(const Identification& found, const std::vector<std::string>& assignments);

}  // namespace soilweave::gws
