// Nonlinear least squares with confidence intervals, for identification.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace soilweave::gws {

/// Estimates from n points for k parameters, with their statistics.
struct Fit {
  std::vector<double> estimates, standard_errors;
  std::vector<double> correlation;        // k x k, row by row
  std::vector<double> fitted, residuals;  // n each; residual = observed - fitted
  std::vector<double> studentized;        // n; residual over its standard error, which includes the leverage
  double scatter = 0;                     // standard deviation of the residuals
  double determination = 0;               // R2 = 1 - residual over total sum of squares
  double freedom = 0;                     // degrees of freedom, n - k

  /// Returns half the width of the 95 % interval of parameter i: t(n - k) standard errors; infinite if n = k.
  double half_width(std::size_t i) const;
};

/// Distance in standard errors beyond which a residual is reported as an outlier.
inline constexpr double outlier_distance = 3;

/// Minimises the sum of squares of observed[i] - model(parameters)[i] from `start`, by Levenberg-Marquardt (GSL).
/// Throws DataError naming `what` if the points are fewer than the parameters or do not determine them.
Fit fit(const std::string& what, const std::vector<double>& observed, const std::vector<double>& start,
        const std::function<void(const double* parameters, double* fitted)>& model);

}  // namespace soilweave::gws
