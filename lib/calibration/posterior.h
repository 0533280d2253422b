// Moments, quantiles and densities of weighted parameters. Weights sum to 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "calibration/prior.h"

namespace soilweave::calibration {

/// Returns the weighted mean of each column, in its unit, not in logs (thesis chapter 2, for E too).
Vector weighted_mean(const Matrix& values, const Vector& weight);
/// Returns the sum of w (x - mean)(x - mean)^T.
Matrix weighted_covariance(const Matrix& values, const Vector& weight);
/// Returns the value below which a share of the weight lies, linear between the middles of weights.
double weighted_quantile(const Vector& values, const Vector& weight, double share);

/// Marginal density over the range of one parameter.
struct Density {
  /// Values of the parameter.
  std::vector<double> value;
  /// Density per unit of the parameter; on a log scale per decade.
  std::vector<double> density;
  /// Width of the kernels in the coordinate.
  double bandwidth = 0;
};

/// Returns the density at `points` values: weighted Gaussian kernels in the coordinate, mirrored at the ends.
/// Bandwidth: Silverman's (1986) rule with the effective size, at least a hundredth of the range.
Density marginal_density(const Range& range, const Vector& values, const Vector& weight, std::size_t points);

}  // namespace soilweave::calibration
