// Sequential importance sampling, step by step in logs: thesis Eqs. 2.3 to 2.8. N members, T steps, C observables.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which parameters of a grain model explain a laboratory test? Draw N parameter sets from a prior, run each, and weigh
// them by how well they predict the observations. At station t, member i predicts x_t(i), the laboratory measured y_t,
// and the error of observation is Gaussian with variance R. The likelihood is
//
//   p(y_t | i) ~ exp(-chi2_t(i) / 2),   chi2_t(i) = sum over c of (y_tc - x_tc(i))^2 / R_tc        Eq. 2.7
//
// and the weights follow recursively, normalised to a sum of 1 at every station:
//
//   w_t(i) ~ w_{t-1}(i) p(y_t | i)                                                                  Eq. 2.8
//
// Hence log w_t(i) is the prior's log weight minus half of all chi2 so far. Weights are kept in logs, since
// exp(-chi2/2) is zero in doubles beyond a chi2 of 1490, and zero over zero would be a NaN in all later steps.
//
// Few members soon carry all the weight. The effective size 1 / sum of w^2 counts them: N for equal weights, 1 for a
// single survivor. Means and densities of a posterior (posterior.h) mean little at a few. Then the error model is too
// strict, or the next round must be drawn where the weight is (proposal.h). filter_to_size() searches the variance that
// keeps a wanted size, so that no step degenerates.
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
  std::vector<double> size;  // uniform: one variance; component: C variances; else one relative standard deviation
};

/// Returns the kind of this name:
/// - uniform: one variance for all components, as in the thesis;
/// - component: one variance for each component;
/// - relative: the standard deviation is a share of each observation, at least of 1 % of the greatest;
/// - largest: the standard deviation is a share of the greatest observation.
ErrorModel::Kind error_kind(std::string_view name);

/// Returns the variances, T x C, in squared units of the observations. Throws DataError if the sizes do not fit.
Matrix variances(const ErrorModel& model, const Observations& observed);

/// Returns chi2_t(i) = sum over c of (y_tc - x_tc(i))^2 / R_tc, N x T; infinite for members without a run.
Matrix misfits(const Observations& observed, const Simulated& runs, const Matrix& variance);

/// Weights of all members at all stations, and measures of how far they can be trusted.
struct Filtered {
  Matrix log_weight;           // N x T, each column normalised; -inf: no weight
  Vector effective_size;       // T, 1 / sum of w^2
  Vector log_evidence;         // T, log p(y_1..t)
  Vector least_misfit;         // T, smallest chi2 of that step among members with weight before it
  double variance_factor = 1;  // factor on all variances

  /// Returns the weights after a step, which sum to 1.
  Vector weights(Eigen::Index step) const;
};

/// Weights all members by Eqs. 2.6 to 2.8, from the prior's log weights (N). The constant of the Gaussian enters only
/// the evidence. Throws DataError if no member has a finite misfit.
Filtered filter(const Matrix& misfit, const Matrix& variance, const Vector& log_prior);

/// Weights all members with variances multiplied by the smallest factor that keeps the effective size at `least` or
/// more in every step. Throws DataError if there is no such factor.
Filtered filter_to_size(const Matrix& misfit, const Matrix& variance, const Vector& log_prior, double least);

/// Largest chi2 of one step with exp(-chi2/2) > 0 in doubles. Beyond it every likelihood is zero unless in logs.
inline constexpr double underflow_misfit = 1490;

/// Returns exp of each, exactly 0 for -inf, unlike Eigen's vector form.
Vector exponentials(const Vector& logs);
/// Returns the log of the sum of exponentials; -inf for none.
double log_sum(const Vector& logs);

/// Returns 1 / sum of w^2 for weights that sum to 1.
double effective_size(const Vector& weight);

}  // namespace soilweave::calibration
