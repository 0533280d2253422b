// One identified line of the wrapped soil: its points, its constants with their intervals, and what is left over.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gws/identification/bag_series.h"
#include "gws/identification/fit.h"

namespace soilweave::gws {

/// Points of one line: their coordinates, what is fitted, and the series and row of each point.
struct Line {
  std::string name;                    // key of the line, as "near_failure_line"
  std::vector<std::string> constants;  // keys of the constants, in the order of fit.estimates
  std::vector<double> given;           // constants of the soil that identification started from
  std::vector<double> x, y;            // coordinates in the thesis's figure
  std::vector<std::size_t> series, row;
  std::string x_name, x_unit, y_name, y_unit;
  std::vector<double> ordinate;  // ordinate of the fitted line at each x
  std::string residual_name,
      residual_unit;  // quantity that is fitted: y, or increments of strain if y is a ratio of them
  Fit fit;
};

/// Points of plain tables, SI: (p, eps_v) of the compression line, (p, q/p) at failure.
struct Points {
  std::vector<double> x, y;
};

/// Change from row i to row i + 1. Strains are fractions. dp* (Eq. 5.14) uses K_psi from the dilatancy line.
struct Increment {
  double plastic_axial = 0, plastic_volumetric = 0, plastic_deviatoric = 0;
  double generalized_stress = 0;                // dp*, Pa
  double failure_obliquity = 0, obliquity = 0;  // M_f and q/p of the increment
};

/// State that an increment between two rows belongs to: the middle, or the end (as in the thesis's figures).
enum class Difference { central, backward };

/// Returns the increment from row i of a series to the next.
Increment increment(const BagSeries& series, std::size_t i, const Soil& soil, Difference difference);

/// Returns a line without points: its constants (symbols of `name`'s table) and the axes of its figure, each a name and
/// a unit.
Line started(const std::string& name, const std::vector<std::string>& symbols, const std::array<const char*, 4>& axes);

/// Adds a point of row `row` of series number `series`.
void put_point(Line& line, double x, double y, std::size_t series, std::size_t row);

/// Returns the points of the dilatancy line (thesis Fig. 5.12) of all increments of the series that begin at rest, with
/// the elastic strain of `soil`; the increments themselves go into `increments`.
Line dilatancy_points(const std::vector<BagSeries>& series, const Soil& soil, Difference difference,
                      std::vector<Increment>& increments);

/// Returns the points of the near-failure-state line (thesis Fig. 5.7) of all rows.
Line near_failure_points(const std::vector<BagSeries>& series, const Soil& soil);

/// The description of a constant by its key.
const Constant& constant(const std::string& key);

}  // namespace soilweave::gws
