// All constants of the wrapped soil fitted at once to the paths of several bags, so that none has to be known before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "gws/identification/bag_series.h"
#include "gws/identification/fit.h"
#include "gws/solution/soil.h"

namespace soilweave::gws {

/// Number of relations that are fitted, one column of PathFit::residuals each. The first is q/p on the near-failure
/// line at the measured p and strain. The second and third are ln p and the volumetric strain (percent) of the solution
/// at the measured axial strain. A residual is the measured value less the computed one.
inline constexpr Eigen::Index path_relations = 3;

/// Constants of all paths, and Young's modulus of each bag.
struct PathFit {
  Soil soil;                    // alpha and beta as given
  std::vector<double> modulus;  // E of each bag that begins at rest, Pa
  /// Keys of the fitted constants, in the order of the rows of `covariance`; after them ln E of these bags.
  std::vector<std::string> keys;
  Eigen::MatrixXd covariance;
  double freedom = 0;                      // degrees of freedom of the intervals
  std::vector<Eigen::MatrixXd> residuals;  // of each bag, rows x path_relations; zero where a relation does not hold
};

/// Least squares along the solution's path from rest at p_0. The independent variable is the measured axial strain;
/// bags are joined by their common constants. `start` and `modulus`: where the search begins. `compression_known`:
/// C_t and p_0 are taken from `start`. A bag that does not begin at rest has the first relation alone, and no modulus.
///
/// Residuals of one bag are correlated from row to row. They are therefore whitened with their autocorrelation, one for
/// each relation (Cochrane and Orcutt 1949). The covariance is the sandwich estimate with each row a cluster and its
/// leverage counted (MacKinnon and White 1985). It is never below the covariance of equal and independent errors, nor
/// are errors ever taken to be below `data_accuracy`.
///
/// Throws DataError where there are fewer rows than constants, where the rows do not determine the constants, or where
/// the solution ends before a bag's last row.
PathFit fit_paths(const std::vector<BagSeries>& bags, const Soil& start, const std::vector<double>& modulus,
                  bool compression_known);

}  // namespace soilweave::gws
