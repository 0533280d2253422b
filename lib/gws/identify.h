// The lines of the wrapped soil (thesis Figs. 5.6, 5.7, 5.10 to 5.14) identified from discrete-element or laboratory
// series. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "gws/fit.h"
#include "gws/soil.h"
#include "io/records.h"

namespace soilweave::gws {

/// One bag under rising surcharge. Strains as fractions, engineering (of the initial lengths), compression positive;
/// Pa.
struct BagSeries {
  std::string name;
  double stiffness = 0;  // J of its geotextile, N/m
  std::vector<double> strain_axial, strain_volumetric, mean_stress, deviatoric_stress;
  std::vector<bool> contracting;  // rows of the compression line; empty: chosen by contraction()
  std::size_t first_row = 0;      // rows of the table or run before these
  std::string note;               // which rows of a run these are, and whose stiffness; empty for tables

  std::size_t size() const { return mean_stress.size(); }
  double strain_deviatoric(std::size_t i) const { return strain_axial[i] - strain_volumetric[i] / 3; }
};

/// Columns strain_axial (or strain_zz, z being the loading axis), strain_volumetric, mean_stress, deviatoric_stress in
/// any unit of their kind, as the tools write them; optional contracting (0 or 1) and tensile_stiffness (the same in
/// every row; else `stiffness`, NaN: none given). natural: strains are logarithmic, as homogenize writes them. Rows
/// after the greatest axial stress (global failure) are left out. first_row: rows that were left out before these.
/// Throws DataError naming `where`.
BagSeries bag_series(const io::Series& table, const std::string& where, double stiffness, bool natural,
                     std::size_t first_row = 0);

/// Points of one line: what is plotted, what is fitted, from which series and row.
struct Line {
  std::string name;                    // "near_failure_line"
  std::vector<std::string> constants;  // keys, in the order of fit.estimates
  std::vector<double> given;           // the constants of the soil that identification started from
  std::vector<double> x, y;            // as the thesis's figure plots them
  std::vector<std::size_t> series, row;
  std::string x_name, x_unit, y_name, y_unit;
  std::vector<double> ordinate;              // of the line at x
  std::string residual_name, residual_unit;  // of what is fitted: y, or increments of strain where y is a ratio of them
  Fit fit;
};

/// Points of plain tables: (p, eps_v) of the compression line, (p, q/p) at failure. SI.
struct Points {
  std::vector<double> x, y;
};

/// What happens from row i to i + 1. Strains are fractions; K_psi in dp* (Eq. 5.14) is from the dilatancy line.
struct Increment {
  double plastic_axial = 0, plastic_volumetric = 0, plastic_deviatoric = 0;
  double generalized_stress = 0;                // dp*, Pa
  double failure_obliquity = 0, obliquity = 0;  // that the increment belongs to
};
struct Identification {
  std::vector<Line> lines;                         // those that the data allow, in the order of Table 5.2
  std::vector<std::vector<Increment>> increments;  // of each series
  std::vector<std::string> left_out;               // why a line is not among them
  SoilFile soil;                                   // the identified constants with their scatter, the others as given
};

enum class Difference { central, backward };

/// Each line is fitted with the constants of the other lines as `soil` has them. `compression` and `failure` (empty:
/// none): points of their lines from other tests. M, p_a, m and Poisson's ratio are not identified: M and p_c are one
/// constant together, m and nu are taken as the thesis takes them. Increments between rows: their stress ratio in the
/// middle (central) or at the end (backward, as the thesis's figures). No point is dropped.
///
/// Where the thesis plots ratios or increments, what is fitted has equal errors: the dilatancy line, increments of
/// plastic volumetric strain (a ratio of two small increments has errors of its own size); Young's modulus, the plastic
/// axial strain accumulated over the accumulated p*.
Identification identify(const std::vector<BagSeries>& series, const SoilFile& soil, const Points& compression,
                        const Points& failure, Difference difference);

/// Returns the ranges of stiffness, mean stress and axial strain that the series span.
Identified range_of(const std::vector<BagSeries>& series);

/// Rows of a series that count as contraction: from the first as long as the slope of eps_v over (p/p_a)^m is at least
/// half of the steepest before it.
std::size_t contraction(const BagSeries& series, const Soil& soil);

/// From row i of a series to the next.
Increment increment(const BagSeries& series, std::size_t i, const Soil& soil, Difference difference);

}  // namespace soilweave::gws
