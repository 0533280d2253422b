// Identifies the lines of the wrapped soil (thesis Figs. 5.6, 5.7, 5.10 to 5.14) from discrete-element or laboratory
// series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "gws/fit.h"
#include "gws/soil.h"
#include "io/records.h"

namespace soilweave::gws {

/// One bag under rising surcharge. Stresses in Pa. Strains are engineering strains as fractions, compression positive.
struct BagSeries {
  std::string name;
  double stiffness = 0;  // J of its geotextile, N/m
  std::vector<double> strain_axial, strain_volumetric, mean_stress, deviatoric_stress;
  std::vector<bool> contracting;  // rows of the compression line; empty: contraction() chooses them
  std::size_t first_row = 0;      // number of rows of the table or run before these
  std::string note;               // rows of a run, and source of the stiffness; empty for tables

  /// Returns the number of rows.
  std::size_t size() const { return mean_stress.size(); }
  /// Returns eps_d = eps_a - eps_v / 3 of row i.
  double strain_deviatoric(std::size_t i) const { return strain_axial[i] - strain_volumetric[i] / 3; }
};

/// Reads a series from a table with the columns strain_axial (or strain_zz, if z is the loading axis),
/// strain_volumetric, mean_stress and deviatoric_stress, in any unit of their kind. Optional columns: contracting (0 or
/// 1) and tensile_stiffness, which is equal in all rows; without it `stiffness` counts (NaN: none given). `natural`:
/// strains are logarithmic, as homogenize writes them. Rows after the greatest axial stress (global failure) are left
/// out. `first_row`: number of rows left out before these. Throws DataError naming `where`.
BagSeries bag_series(const io::Series& table, const std::string& where, double stiffness, bool natural,
                     std::size_t first_row = 0);

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
/// Result of an identification.
struct Identification {
  std::vector<Line> lines;                         // lines that the data allow, in the order of Table 5.2
  std::vector<std::vector<Increment>> increments;  // increments of each series
  std::vector<std::string> left_out;               // reason for each line that is missing
  SoilFile soil;                                   // identified constants with their scatter; all others as given
};

enum class Difference { central, backward };

/// Fits each line with the constants of the other lines taken from `soil`. `compression` and `failure` (empty: none)
/// are points of their lines from other tests. M, p_a, m and Poisson's ratio are not identified: M and p_c are one
/// constant together, m and nu have the thesis's values. The stress ratio of an increment is the one in its middle
/// (central) or at its end (backward, as in the thesis's figures). No point is dropped.
///
/// Least squares needs equal errors, and ratios of two small increments do not have them. So the dilatancy line is
/// fitted to increments of plastic volumetric strain, and Young's modulus to the accumulated plastic axial strain over
/// the accumulated p*.
Identification identify(const std::vector<BagSeries>& series, const SoilFile& soil, const Points& compression,
                        const Points& failure, Difference difference);

/// Returns the ranges of stiffness, mean stress and axial strain that the series span.
Identified range_of(const std::vector<BagSeries>& series);

/// Returns the number of rows at the start of a series that count as contraction: those where the slope of eps_v over
/// (p/p_a)^m is at least half of the steepest slope before it.
std::size_t contraction(const BagSeries& series, const Soil& soil);

/// Returns the increment from row i of a series to the next row.
Increment increment(const BagSeries& series, std::size_t i, const Soil& soil, Difference difference);

}  // namespace soilweave::gws
