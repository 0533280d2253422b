// Series of one bag under rising surcharge, which the lines of its soil are identified from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/records.h"
#include "gws/solution/soil.h"

namespace soilweave::gws {

/// One bag under rising surcharge. Stresses in Pa. Strains are engineering strains as fractions, compression positive.
struct BagSeries {
  std::string name;
  double stiffness = 0;  // J of its geotextile, N/m
  std::vector<double> strain_axial, strain_volumetric, mean_stress, deviatoric_stress;
  std::vector<bool> contracting;  // rows of the compression line; empty: contraction() chooses them
  std::size_t first_row = 0;      // number of rows of the table or run before these
  bool from_rest = true;          // strains begin where the solution does; false: from another stress, as in a cell
  std::string note;               // which rows of a run these are, and whose stiffness; empty for tables

  /// Returns the number of rows.
  std::size_t size() const { return mean_stress.size(); }
  /// Returns eps_d = eps_a - eps_v / 3 of row i.
  double strain_deviatoric(std::size_t i) const { return strain_axial[i] - strain_volumetric[i] / 3; }
  /// Returns the series without its first n rows.
  BagSeries from_row(std::size_t n) const;
};

/// Reads a series from a table with the columns strain_axial (or strain_zz, if z is the loading axis),
/// strain_volumetric, mean_stress and deviatoric_stress, in any unit of their kind. Optional columns: contracting (0 or
/// 1) and tensile_stiffness, which is equal in all rows; without it `stiffness` counts (NaN: none given). `natural`:
/// strains are logarithmic, as homogenize writes them. Rows after the greatest axial stress (global failure) are left
/// out. `first_row`: number of rows left out before these. Throws DataError naming `where`.
BagSeries bag_series(const io::Series& table, const std::string& where, double stiffness, bool natural,
                     std::size_t first_row = 0);

/// Returns the ranges of stiffness, mean stress and axial strain that the series span.
Identified range_of(const std::vector<BagSeries>& series);

}  // namespace soilweave::gws
