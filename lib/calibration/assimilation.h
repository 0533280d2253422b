// A whole assimilation, from ensemble, observations and runs to tables and text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/ensemble.h"
#include "calibration/observations.h"
#include "calibration/particle_filter.h"
#include "files/files.h"

namespace soilweave::calibration {

/// Description of the filter, with its source.
inline constexpr std::string_view assumptions =
    "Sequential importance sampling after H. Cheng's dissertation (Hiroshima University, 2016, section 2.2): parameter "
    "sets drawn from a prior are run once, by any code; each observation multiplies their weights by its Gaussian "
    "likelihood, in logs. Few sets end up with all the weight where the prior is wide: the effective sample size "
    "tells, "
    "and resample draws the next ensemble around the posterior, with the importance that keeps the result unbiased.";

/// Input and results of an assimilation.
struct Assimilation {
  /// Members with the weights of the last step.
  Ensemble ensemble;
  Observations observed;
  Simulated runs;
  /// chi2, N x T; variances with their factor, T x C.
  Matrix misfit, variance;
  Filtered filtered;
  /// Effective share of the initial weights that the observations keep; 1 if all likelihoods are equal.
  double kept_share = 0;
  /// Steps for densities and covariances.
  std::vector<Eigen::Index> chosen;
};

/// Assimilates all steps. least_size: least effective size over members; the error model then gives only the variance's
/// shape, and its size is searched. stations: positions for densities and covariances; each is taken at the last
/// station up to it. Empty: the last station. goes_on: starts from the ensemble's weights of earlier tests, so that all
/// tests count.
Assimilation assimilate(Ensemble ensemble, Observations observed, Simulated runs, const ErrorModel& model,
                        std::optional<double> least_size, const std::vector<double>& stations, bool goes_on = false);

/// Returns the names of the tables of groups_of() in order, then "curves".
std::vector<std::string> assimilation_table_names();
/// Returns the tables for files. steps: parameters' means, deviations, and 5 and 95 % quantiles; effective size,
/// evidence, predictions. weights: one column per step. covariance, density: at the chosen steps. runs: fate, and root
/// mean squares of deviations from the observations.
std::vector<io::FieldsFile::Group> groups_of(const Assimilation& a);
/// Returns a table of `groups`, made by groups_of(), or "curves", the used runs at the stations. Files omit curves,
/// which the runs hold.
io::Series table_of(const Assimilation& a, const std::vector<io::FieldsFile::Group>& groups, std::string_view name);

}  // namespace soilweave::calibration
