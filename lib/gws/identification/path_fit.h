// Fit of all constants at once to the paths of several bags.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "gws/identification/bag_series.h"
#include "gws/identification/fit.h"
#include "gws/solution/soil.h"

namespace soilweave::gws {

/// Number of fitted relations, the columns of PathFit::residuals. First: q/p on the near-failure line at the measured p
/// and strain. Second and third: ln p and volumetric strain (percent) at the measured axial strain. A residual is
/// measured less computed.
inline constexpr Eigen::Index path_relations = 3;

/// Constants of all paths, and each bag's modulus.
struct PathFit {
  /// alpha and beta as given.
  Soil soil;
  /// E of each bag that begins at rest, Pa.
  std::vector<double> modulus;
  /// Keys of the rows of `covariance`: fitted constants, then ln E of these bags.
  std::vector<std::string> keys;
  Eigen::MatrixXd covariance;
  /// Degrees of freedom of the intervals.
  double freedom = 0;
  /// One per bag, rows x path_relations; zero where a relation does not hold.
  std::vector<Eigen::MatrixXd> residuals;
};

/// Least squares along the solution's path from rest at p_0. The independent variable is the measured axial strain;
/// bags share the constants. start, modulus: first guess. compression_known: C_t and p_0 are those of `start`. A bag
/// not from rest has the first relation alone, and no modulus.
///
/// Residuals are whitened with one autocorrelation per relation, since those of neighbouring rows are correlated
/// (Cochrane and Orcutt 1949). Variances are the greater of two estimates: the sandwich estimate with rows as clusters
/// and their leverage (MacKinnon and White 1985), and the estimate from independent errors of at least `data_accuracy`.
/// Correlations come from the latter.
///
/// Throws DataError if rows are too few or do not determine the constants, or if the solution ends before a bag's last
/// row.
PathFit fit_paths(const std::vector<BagSeries>& bags, const Soil& start, const std::vector<double>& modulus,
                  bool compression_known);

}  // namespace soilweave::gws
