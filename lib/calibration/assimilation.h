// An assimilation as a whole: ensemble, observations and runs go in; tables and a text for a reader come out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/ensemble.h"
#include "calibration/observations.h"
#include "calibration/particle_filter.h"
#include "io/files.h"

namespace soilweave::calibration {

/// What the filter is, with its source.
inline constexpr std::string_view assumptions =
    "Sequential importance sampling after H. Cheng's dissertation (Hiroshima University, 2016, section 2.2): parameter "
    "sets drawn from a prior are run once, by any code; each observation multiplies their weights by its Gaussian "
    "likelihood, in logs. Few sets end up with all the weight where the prior is wide: the effective sample size "
    "tells, "
    "and resample draws the next ensemble around the posterior, with the importance that keeps the result unbiased.";

struct Assimilation {
  Ensemble ensemble;  // with the weights of the last step
  Observations observed;
  Simulated runs;
  Matrix misfit, variance;  // N x T; T x C, its factor included
  Filtered filtered;
  std::vector<Eigen::Index> chosen;  // steps of densities and covariances
};

/// least_size: as share of the members, then the error model gives the shape of the variance and its size is searched.
/// stations: where densities and covariances are wanted, each the last station not beyond it; none: the last one.
Assimilation assimilate(Ensemble ensemble, Observations observed, Simulated runs, const ErrorModel& model,
                        std::optional<double> least_size, const std::vector<double>& stations);

/// The names of the tables of groups_of, in order, and curves.
std::vector<std::string> assimilation_table_names();
/// Tables for files. steps: means, deviations and 5 and 95 % quantiles of each parameter, effective size, evidence,
/// predictions; weights: a column a step; covariance, density: at the chosen steps; runs: what became of each, and root
/// mean squares of its deviations from the observations.
std::vector<io::FieldsFile::Group> groups_of(const Assimilation& a);
/// The table with one of the names above: from `groups`, made by groups_of, or `curves`, the used runs at the stations.
/// Files do not hold that one, since the runs do.
io::Series table_of(const Assimilation& a, const std::vector<io::FieldsFile::Group>& groups, std::string_view name);

/// What is wrong with the weights, a sentence each: degeneracy, likelihoods beyond double precision, unused runs.
std::vector<std::string> warnings(const Assimilation& a);
/// Where every likelihood of a step is zero in double precision: what to say.
std::optional<std::string> all_zero(const Assimilation& a);
/// Runs that are not used, the error model, a table of some steps, the parameters at the end.
std::string describe(const Assimilation& a);

}  // namespace soilweave::calibration
