// One identified line of the wrapped soil.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/doubts.h"
#include "gws/identification/bag_series.h"
#include "gws/identification/fit.h"

namespace soilweave::gws {

/// Points of one line, and their fit.
struct Line {
  /// Key, as "near_failure_line".
  std::string name;
  /// Keys of the constants, in the order of fit.estimates.
  std::vector<std::string> constants;
  /// Constants that identification started from.
  std::vector<double> given;
  /// Coordinates in the thesis's figure.
  std::vector<double> x, y;
  /// Series and row of each point.
  std::vector<std::size_t> series, row;
  std::string x_name, x_unit, y_name, y_unit;
  /// Ordinate of the fitted line at each x.
  std::vector<double> ordinate;
  /// Fitted quantity: y, or increments of strain if y is their ratio.
  std::string residual_name, residual_unit;
  Fit fit;
};

/// Points of plain tables, SI: (p, eps_v) or, at failure, (p, q/p). The doubts are about the tables themselves.
struct Points {
  std::vector<double> x, y;
  std::vector<Doubt> doubts = {};
};

/// Change from row i to row i + 1. Strains are fractions.
struct Increment {
  double plastic_axial = 0, plastic_volumetric = 0, plastic_deviatoric = 0;
  /// dp* (Eq. 5.14), Pa, with K_psi of the dilatancy line.
  double generalized_stress = 0;
  /// M_f and q/p of the increment.
  double failure_obliquity = 0, obliquity = 0;
};

/// State of an increment between two rows: the middle, or the end as in the thesis.
enum class Difference { central, backward };

/// Returns the increment from row i of a series to the next.
Increment increment(const BagSeries& series, std::size_t i, const Soil& soil, Difference difference);

/// Returns a line without points. axes: name and unit of each axis.
Line started(const std::string& name, const std::vector<std::string>& symbols, const std::array<const char*, 4>& axes);

/// Adds a point. series, row: numbers.
void put_point(Line& line, double x, double y, std::size_t series, std::size_t row);

/// Returns the points of the dilatancy line (thesis Fig. 5.12), from series that begin at rest. `soil` gives the
/// elastic strain; `increments` receives the increments.
Line dilatancy_points(const std::vector<BagSeries>& series, const Soil& soil, Difference difference,
                      std::vector<Increment>& increments);

/// Returns the points of the near-failure line (thesis Fig. 5.7) of all rows.
Line near_failure_points(const std::vector<BagSeries>& series, const Soil& soil);

/// Returns the description of a constant by its key.
const Constant& constant(const std::string& key);

}  // namespace soilweave::gws
