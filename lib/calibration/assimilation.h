// A whole assimilation: from ensemble, observations and runs to tables and a text for a reader.
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

/// Everything that an assimilation has read and found.
struct Assimilation {
  Ensemble ensemble;  // members with the weights of the last step
  Observations observed;
  Simulated runs;
  Matrix misfit, variance;  // N x T; T x C, with its factor
  Filtered filtered;
  std::vector<Eigen::Index> chosen;  // steps at which densities and covariances are given
};

/// Assimilates all steps. least_size: least effective size as a share of the members; the error model then gives the
/// shape of the variance, and its size is searched. stations: where densities and covariances are wanted, each taken at
/// the last station not beyond it; empty: the last station.
/// goes_on: begins with the ensemble's weights, which other tests of the same sets gave it, so that all tests count.
Assimilation assimilate(Ensemble ensemble, Observations observed, Simulated runs, const ErrorModel& model,
                        std::optional<double> least_size, const std::vector<double>& stations, bool goes_on = false);

/// Returns the names of the tables of groups_of() in order, then "curves".
std::vector<std::string> assimilation_table_names();
/// Returns the tables for files. steps: means, deviations, and 5 and 95 % quantiles of each parameter, effective size,
/// evidence, predictions. weights: a column per step. covariance, density: at the chosen steps. runs: the fate of each
/// run, and the root mean squares of its deviations from the observations.
std::vector<io::FieldsFile::Group> groups_of(const Assimilation& a);
/// Returns the table of that name: one of `groups`, made by groups_of(), or "curves", the used runs at the stations.
/// Files omit the curves, since the runs hold them.
io::Series table_of(const Assimilation& a, const std::vector<io::FieldsFile::Group>& groups, std::string_view name);

/// Returns doubts about the weights, a sentence each: degeneracy, likelihoods beyond double precision, unused runs.
std::vector<std::string> warnings(const Assimilation& a);
/// Returns a message if every likelihood of a step is zero in double precision.
std::optional<std::string> all_zero(const Assimilation& a);
/// Describes the unused runs, the error model, some steps, and the parameters at the end.
std::string describe(const Assimilation& a);

}  // namespace soilweave::calibration
