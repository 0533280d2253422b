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

/// Fills in scatter, determination, fitted values and studentized residuals of a fit of `constants` constants, from its
/// residuals and what was observed; studentized by the scatter alone where there are none yet. Residuals below
/// `data_accuracy` times the greatest observed value are no outliers, whatever their scatter.
void summarize(Fit& fit, const std::vector<double>& observed, std::size_t constants);

/// The best relative accuracy that data are taken to have: tables are written, and solutions computed, to about that.
inline constexpr double data_accuracy = 1e-6;

/// Distance in standard errors beyond which a residual is reported as an outlier.
inline constexpr double outlier_distance = 3;

/// Minimises the sum of squares of observed[i] - model(parameters)[i] from `start`, by Levenberg-Marquardt (GSL).
/// Throws DataError naming `what` if the points are fewer than the parameters or do not determine them.
Fit fit(const std::string& what, const std::vector<double>& observed, const std::vector<double>& start,
        const std::function<void(const double* parameters, double* fitted)>& model);

}  // namespace soilweave::gws
