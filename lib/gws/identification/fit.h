// Nonlinear least squares with confidence intervals.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace soilweave::gws {

/// Fit of k parameters to n points.
struct Fit {
  std::vector<double> estimates, standard_errors;
  /// Correlation of estimates, k x k, row by row.
  std::vector<double> correlation;
  /// Values and residuals of the n points; residual = observed - fitted.
  std::vector<double> fitted, residuals;
  /// Residuals of the n points over their standard errors, with leverage.
  std::vector<double> studentized;
  /// Standard deviation of the residuals.
  double scatter = 0;
  /// R2 = 1 - residual over total sum of squares.
  double determination = 0;
  /// Degrees of freedom, n - k.
  double freedom = 0;

  /// Returns half the 95 % interval of parameter i: t(n - k) standard errors; infinite if n = k.
  double half_width(std::size_t i) const;
};

/// Fills in scatter, determination and fitted values from the residuals, and studentized residuals if absent, from the
/// scatter. constants: number of constants. Residuals below `data_accuracy` times the greatest observed value are no
/// outliers.
void summarize(Fit& fit, const std::vector<double>& observed, std::size_t constants);

/// Best relative accuracy of data. Tables and solutions have about that.
inline constexpr double data_accuracy = 1e-6;

/// Least sine of the angle between a column of the Jacobian and the others at which points determine a constant.
inline constexpr double least_sine = 1e-6;

/// Studentized residual beyond which a point is an outlier.
inline constexpr double outlier_distance = 3;

/// Minimises the sum of squares of observed[i] - model(parameters)[i] from `start`, by Levenberg-Marquardt (GSL).
/// Throws DataError naming `what` for too few or undetermining points.
Fit fit(const std::string& what, const std::vector<double>& observed, const std::vector<double>& start,
        const std::function<void(const double* parameters, double* fitted)>& model);

}  // namespace soilweave::gws
