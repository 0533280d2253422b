// Least squares with intervals: what identification rests on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace soilweave::gws {

/// Estimates with what is known about them. n points, k parameters.
struct Fit {
  std::vector<double> estimates, standard_errors;
  std::vector<double> correlation;        // k x k, row by row
  std::vector<double> fitted, residuals;  // n; residual = observed - fitted
  std::vector<double> studentized;        // n; residual over its standard error, its leverage counted
  double scatter = 0;                     // standard deviation of the residuals
  double determination = 0;               // R2 = 1 - residual over total sum of squares
  double freedom = 0;                     // n - k

  /// Half width of the 95 % interval of parameter i: t(n - k) standard errors; infinite where n = k.
  double half_width(std::size_t i) const;
};

/// A residual farther out than this many standard errors is reported as an outlier.
inline constexpr double outlier_distance = 3;

/// Least squares of observed - model(parameters)[i] by Levenberg-Marquardt (GSL), from the start given. Throws
/// DataError, naming `what`, where there are fewer points than parameters or they do not determine them.
Fit fit(const std::string& what, const std::vector<double>& observed, const std::vector<double>& start,
        const std::function<void(const double* parameters, double* fitted)>& model);

}  // namespace soilweave::gws
