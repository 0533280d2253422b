// Sequential importance sampling, step by step in logs: thesis Eqs. 2.3 to 2.8. N members, T steps, C observables.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "calibration/observations.h"

namespace soilweave::calibration {

/// What the variance of the observation error is made from.
struct ErrorModel {
  enum class Kind { uniform, component, relative, largest };
  Kind kind = Kind::uniform;
  std::vector<double> size;  // uniform: one variance; component: C variances; else one relative standard deviation
};

/// The kinds by name: uniform (one variance for all components, as in the thesis), component (one each), relative (the
/// standard deviation a share of each observation, no less than of 1 % of the greatest), largest (of the greatest).
ErrorModel::Kind error_kind(std::string_view name);

/// Variances, T x C, in the observations' squared units. Throws DataError where the sizes do not fit the observations.
Matrix variances(const ErrorModel& model, const Observations& observed);

/// chi2_t(i) = sum over c of (y_tc - x_tc(i))^2 / R_tc, N x T; infinite for members without a run.
Matrix misfits(const Observations& observed, const Simulated& runs, const Matrix& variance);

struct Filtered {
  Matrix log_weight;           // N x T, each column normalised; -inf: no weight
  Vector effective_size;       // T, 1 / sum of w^2
  Vector log_evidence;         // T, log p(y_1..t)
  Vector least_misfit;         // T, smallest chi2 of that step among members that have weight before it
  double variance_factor = 1;  // that the variances were multiplied by

  Vector weights(Eigen::Index step) const;
};

/// Eqs. 2.6 to 2.8 from the prior's log weights (N). The Gaussian's constant counts in the evidence alone.
/// Throws DataError where no member has a finite misfit.
Filtered filter(const Matrix& misfit, const Matrix& variance, const Vector& log_prior);

/// The same with all variances multiplied by the smallest factor for which the effective size stays at or above `least`
/// at every step. Throws DataError where no factor reaches that.
Filtered filter_to_size(const Matrix& misfit, const Matrix& variance, const Vector& log_prior, double least);

/// Below this chi2 of one step exp(-chi2/2) is a number; beyond, every likelihood of the step is zero unless in logs.
inline constexpr double underflow_misfit = 1490;

/// exp of each, exactly 0 for -inf, which Eigen's own vector form does not give.
Vector exponentials(const Vector& logs);
/// log of the sum of exponentials; -inf for none.
double log_sum(const Vector& logs);

/// 1 / sum of w^2 of weights that sum to 1.
double effective_size(const Vector& weight);

}  // namespace soilweave::calibration
