// What weights say about the parameters: moments, quantiles, densities. Weights sum to 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "calibration/prior.h"

namespace soilweave::calibration {

/// Weighted mean of each column (thesis chapter 2: E, too, in its own unit and not in logs).
Vector weighted_mean(const Matrix& values, const Vector& weight);
/// Sum of w (x - mean)(x - mean)^T.
Matrix weighted_covariance(const Matrix& values, const Vector& weight);
/// The value below which the share of the weight lies; straight between the members' own middles.
double weighted_quantile(const Vector& values, const Vector& weight, double share);

/// A marginal density over the range of one parameter.
struct Density {
  std::vector<double> value;    // of the parameter
  std::vector<double> density;  // per its unit; on a log scale per decade
  double bandwidth = 0;         // in the coordinate
};

/// Weighted Gaussian kernels in the coordinate, mirrored at the ends of the range, bandwidth by Silverman's (1986) rule
/// with the effective sample size; no narrower than a hundredth of the range. `points` values over the range.
Density marginal_density(const Range& range, const Vector& values, const Vector& weight, std::size_t points);

}  // namespace soilweave::calibration
