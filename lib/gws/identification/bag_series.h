// Series of one bag under rising surcharge, for identification.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/records.h"
#include "gws/solution/soil.h"

namespace soilweave::gws {

/// One bag. Stresses in Pa. Strains are engineering strains, fractions, compression positive.
struct BagSeries {
  std::string name;
  /// J of its geotextile, N/m.
  double stiffness = 0;
  std::vector<double> strain_axial, strain_volumetric, mean_stress, deviatoric_stress;
  /// Rows of the compression line; empty: contraction() chooses.
  std::vector<bool> contracting;
  /// Place of each row in its table or run, from 0.
  std::vector<std::size_t> row;
  /// Whether strains begin where the solution does; false: from another stress.
  bool from_rest = true;
  /// Note on rows taken and left out, and on the source of a run's stiffness. Empty for a table that is taken whole.
  std::string note;

  /// Returns whether the rows of both series are equal, because one bag was given twice.
  bool equal_rows(const BagSeries& other) const {
    return mean_stress == other.mean_stress && deviatoric_stress == other.deviatoric_stress &&
           strain_axial == other.strain_axial && strain_volumetric == other.strain_volumetric;
  }
  /// Returns the number of rows.
  std::size_t size() const { return mean_stress.size(); }
  /// Returns eps_d = eps_a - eps_v / 3 of row i.
  double strain_deviatoric(std::size_t i) const { return strain_axial[i] - strain_volumetric[i] / 3; }
  /// Returns the series without its first n rows.
  BagSeries from_row(std::size_t n) const;
};

/// Reads a series with columns strain_axial (or strain_zz), strain_volumetric, mean_stress and deviatoric_stress, in
/// any unit of their kind. Optional columns: contracting (0 or 1) and a constant tensile_stiffness, else `stiffness`
/// counts (0: none given; both have to agree). natural: strains are logarithmic, as homogenize writes them. Leaves out
/// rows after the greatest axial stress (global failure), and rows with less axial strain than an earlier row
/// (unloading and reloading). The note counts them. first_row: number of rows before the table's first. Throws
/// DataError naming `where`.
BagSeries bag_series(const io::Series& table, const std::string& where, double stiffness, bool natural,
                     std::size_t first_row = 0);

/// Returns the ranges that the series span.
Identified range_of(const std::vector<BagSeries>& series);

}  // namespace soilweave::gws
