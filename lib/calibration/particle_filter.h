// Sequential importance sampling, step by step in logs: thesis Eqs. 2.3 to 2.8. N members, T steps, C observables.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which parameters of a grain model explain a laboratory test? Draw N parameter sets from a prior, run each, and weigh
// them by their predictions. At station t, member i predicts x_t(i), the laboratory measured y_t, and the error is
// Gaussian with variance R. The likelihood is
//
//   p(y_t | i) ~ exp(-chi2_t(i) / 2),   chi2_t(i) = sum over c of (y_tc - x_tc(i))^2 / R_tc        Eq. 2.7
//
// and the weights follow recursively, normalised to a sum of 1 at every station:
//
//   w_t(i) ~ w_{t-1}(i) p(y_t | i)                                                                  Eq. 2.8
//
// So log w_t(i) is the prior's log weight minus half of all chi2 so far. Weights are kept in logs: exp(-chi2/2) is zero
// in doubles beyond a chi2 of 1490, and zero over zero is NaN.
//
// Few members soon carry all the weight. The effective size 1 / sum of w^2 counts these members, from N for equal
// weights to 1. A posterior (posterior.h) of a few means little. Then the error model is too strict, or the next round
// must be drawn where the weight is (proposal.h). filter_to_size() searches the variance that keeps a wanted size.
//
//   const Matrix variance = variances(model, observed);
//   const Filtered filtered = filter(misfits(observed, runs, variance), variance, ensemble.log_prior_weight());
//   const Vector weight = exponentials(filtered.log_weight.rightCols(1));
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "calibration/observations.h"

namespace soilweave::calibration {

/// Model of the variance of the observation error.
struct ErrorModel {
  enum class Kind { uniform, component, relative, largest };
  Kind kind = Kind::uniform;
  /// uniform: one variance; component: C variances; else one relative standard deviation.
  std::vector<double> size;
};

/// Returns the kind of this name:
/// - uniform: one variance, as in the thesis, for observables of one unit;
/// - component: one variance per component;
/// - relative: standard deviation over each observation, at least 1 % of the greatest;
/// - largest: standard deviation over the greatest observation.
ErrorModel::Kind error_kind(std::string_view name);

/// Returns variances, T x C, in squared units. Throws DataError if sizes do not fit.
Matrix variances(const ErrorModel& model, const Observations& observed);

/// Returns chi2_t(i) = sum over c of (y_tc - x_tc(i))^2 / R_tc, N x T; infinite for members without a run.
Matrix misfits(const Observations& observed, const Simulated& runs, const Matrix& variance);

/// Weights of all members at all stations, and their reliability.
struct Filtered {
  /// N x T, each column normalised; -inf: no weight.
  Matrix log_weight;
  /// T, 1 / sum of w^2.
  Vector effective_size;
  /// T, log p(y_1..t).
  Vector log_evidence;
  /// T, smallest chi2 of the step among members with weight.
  Vector least_misfit;
  /// Factor on all variances.
  double variance_factor = 1;

  /// Returns the weights after a step, which sum to 1.
  Vector weights(Eigen::Index step) const;
};

/// Weights all members by Eqs. 2.6 to 2.8, from the prior's log weights (N). The Gaussian's constant enters only the
/// evidence. Throws DataError without a finite misfit.
Filtered filter(const Matrix& misfit, const Matrix& variance, const Vector& log_prior);

/// Multiplies variances by the smallest factor that keeps the effective size at `least` in every step. Throws DataError
/// if there is none.
Filtered filter_to_size(const Matrix& misfit, const Matrix& variance, const Vector& log_prior, double least);

/// Largest chi2 with exp(-chi2/2) > 0 in doubles.
inline constexpr double underflow_misfit = 1490;

/// Returns exp of each, exactly 0 for -inf, unlike Eigen's vector form.
Vector exponentials(const Vector& logs);
/// Returns the log of the sum of exponentials; -inf for none.
double log_sum(const Vector& logs);

/// Returns 1 / sum of w^2 for weights that sum to 1.
double effective_size(const Vector& weight);

}  // namespace soilweave::calibration
