// A whole assimilation, and its tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/assimilation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "calibration/posterior.h"
#include "core/error.h"

namespace soilweave::calibration {
namespace {

constexpr double low_quantile = 0.05, high_quantile = 0.95;
constexpr std::size_t density_points = 101;

std::vector<double> column(const Vector& values) { return {values.data(), values.data() + values.size()}; }

void put(io::Series& table, std::string name, std::string unit, std::string long_name, std::vector<double> values) {
  table.columns.push_back({std::move(name), std::move(unit), std::move(long_name), std::move(values)});
}

/// Adds the columns `step`, counted from 1, and the station; only one column if the station is called step.
void put_station(io::Series& table, const Assimilation& a, const std::vector<double>& steps) {
  std::vector<double> at;
  for (const double t : steps) at.push_back(a.observed.at[static_cast<std::size_t>(t) - 1]);
  if (a.observed.station.name != "step") put(table, "step", "1", "number of the observation, from 1", steps);
  put(table, a.observed.station.name, a.observed.station.unit, "station of the observation", at);
}

std::vector<double> all_steps(const Assimilation& a) {
  std::vector<double> steps;
  for (std::size_t t = 0; t < a.observed.stations(); ++t) steps.push_back(static_cast<double>(t + 1));
  return steps;
}

/// Returns value(weights) of each step.
template <class Value>
std::vector<double> over_steps(const Assimilation& a, const Value& value) {
  std::vector<double> values;
  for (Eigen::Index t = 0; t < a.filtered.log_weight.cols(); ++t) values.push_back(value(a.filtered.weights(t), t));
  return values;
}

/// Returns the values of one observable at one step; 0 for members without a run, which have no weight.
Vector predictions(const Assimilation& a, Eigen::Index t, Eigen::Index c) {
  Vector values = Vector::Zero(static_cast<Eigen::Index>(a.runs.values.size()));
  for (std::size_t i = 0; i < a.runs.values.size(); ++i)
    if (a.runs.values[i].size() > 0) values[static_cast<Eigen::Index>(i)] = a.runs.values[i](t, c);
  return values;
}

io::Series steps_table(const Assimilation& a) {
  io::Series table;
  put_station(table, a, all_steps(a));
  put(table, "effective_size", "1", "effective sample size, 1 / sum of squared weights",
      column(a.filtered.effective_size));
  put(table, "log_evidence", "1", "log of the probability density of the observations up to here",
      column(a.filtered.log_evidence));
  for (std::size_t k = 0; k < a.ensemble.prior.size(); ++k) {
    const Range& range = a.ensemble.prior.ranges[k];
    const Vector values = a.ensemble.values.col(static_cast<Eigen::Index>(k));
    put(table, range.name, range.unit, range.long_name + ", weighted mean",
        over_steps(a, [&](const Vector& w, Eigen::Index) { return values.dot(w); }));
    put(table, range.name + "_deviation", range.unit, "weighted standard deviation",
        over_steps(a, [&](const Vector& w, Eigen::Index) { return std::sqrt(weighted_covariance(values, w)(0, 0)); }));
    put(table, range.name + "_low", range.unit, "quantile of 5 %",
        over_steps(a, [&](const Vector& w, Eigen::Index) { return weighted_quantile(values, w, low_quantile); }));
    put(table, range.name + "_high", range.unit, "quantile of 95 %",
        over_steps(a, [&](const Vector& w, Eigen::Index) { return weighted_quantile(values, w, high_quantile); }));
  }
  for (std::size_t k = 0; k < a.observed.observables.size(); ++k) {
    const auto c = static_cast<Eigen::Index>(k);
    const Observable& what = a.observed.observables[k];
    put(table, what.name + "_observed", what.unit, "observation", column(a.observed.values.col(c)));
    put(table, what.name + "_predicted", what.unit, "weighted mean of the runs",
        over_steps(a, [&](const Vector& w, Eigen::Index t) { return predictions(a, t, c).dot(w); }));
    put(table, what.name + "_error", what.unit, "standard deviation of the observation error",
        column(a.variance.col(c).cwiseSqrt()));
  }
  return table;
}

std::vector<double> id_column(const Assimilation& a) { return {a.ensemble.id.begin(), a.ensemble.id.end()}; }

io::Series weights_table(const Assimilation& a) {
  io::Series table;
  put(table, "id", "1", "number of the parameter set", id_column(a));
  for (std::size_t t = 0; t < a.observed.stations(); ++t)
    put(table, fmt::format("weight_{}", t + 1), "1",
        fmt::format("weight at {} {:.6g} {}", a.observed.station.name, a.observed.at[t], a.observed.station.unit),
        column(a.filtered.weights(static_cast<Eigen::Index>(t))));
  return table;
}

io::Series covariance_table(const Assimilation& a) {
  std::vector<double> steps, row, other, covariance, correlation;
  for (const Eigen::Index t : a.chosen) {
    const Matrix all = weighted_covariance(a.ensemble.values, a.filtered.weights(t));
    for (Eigen::Index i = 0; i < all.rows(); ++i)
      for (Eigen::Index j = 0; j < all.cols(); ++j) {
        const double scale = std::sqrt(all(i, i) * all(j, j));
        steps.push_back(static_cast<double>(t + 1));
        row.push_back(static_cast<double>(i));
        other.push_back(static_cast<double>(j));
        covariance.push_back(all(i, j));
        correlation.push_back(scale > 0 ? all(i, j) / scale : std::nan(""));
      }
  }
  io::Series table;
  put_station(table, a, steps);
  put(table, "parameter", "1", "number of the parameter, from 0", row);
  put(table, "other", "1", "number of the other parameter, from 0", other);
  put(table, "covariance", "its own", "covariance of the two", covariance);
  put(table, "correlation", "1", "covariance over the product of the standard deviations", correlation);
  return table;
}

io::Series density_table(const Assimilation& a) {
  std::vector<double> steps, parameter, value, density;
  for (const Eigen::Index t : a.chosen)
    for (std::size_t k = 0; k < a.ensemble.prior.size(); ++k) {
      const Density d =
          marginal_density(a.ensemble.prior.ranges[k], a.ensemble.values.col(static_cast<Eigen::Index>(k)),
                           a.filtered.weights(t), density_points);
      steps.insert(steps.end(), d.value.size(), static_cast<double>(t + 1));
      parameter.insert(parameter.end(), d.value.size(), static_cast<double>(k));
      value.insert(value.end(), d.value.begin(), d.value.end());
      density.insert(density.end(), d.density.begin(), d.density.end());
    }
  io::Series table;
  put_station(table, a, steps);
  put(table, "parameter", "1", "number of the parameter, from 0", parameter);
  put(table, "value", "its own", "value of the parameter", value);
  put(table, "density", "1 per its own", "marginal posterior density; per decade on a log scale", density);
  return table;
}

double root_mean_square(const Vector& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

io::Series runs_table(const Assimilation& a) {
  std::vector<double> fate, misfit;
  for (std::size_t i = 0; i < a.runs.fate.size(); ++i) {
    const double sum = a.misfit.row(static_cast<Eigen::Index>(i)).sum();
    fate.push_back(static_cast<double>(a.runs.fate[i]));
    misfit.push_back(std::isfinite(sum) ? sum : std::nan(""));
  }
  io::Series table;
  put(table, "id", "1", "number of the parameter set", id_column(a));
  put(table, "fate", "1", "0 used, 1 missing, 2 unreadable, 3 out of order, 4 diverged, 5 too short", fate);
  put(table, "misfit", "1", "sum of squared deviations over the variance", misfit);
  put(table, "weight", "1", "posterior weight", column(a.ensemble.weight));
  for (std::size_t k = 0; k < a.observed.observables.size(); ++k) {
    const Observable& what = a.observed.observables[k];
    const Vector observed = a.observed.values.col(index(k));
    std::vector<double> absolute, relative;
    for (const Matrix& run : a.runs.values) {
      const bool used = run.size() > 0;
      const Vector deviation = used ? Vector(run.col(index(k)) - observed) : Vector::Constant(1, std::nan(""));
      absolute.push_back(root_mean_square(deviation));
      relative.push_back(used && (observed.array() != 0).all() ? root_mean_square(deviation.cwiseQuotient(observed))
                                                               : std::nan(""));
    }
    put(table, what.name + "_misfit", what.unit, "root mean square of the deviation over the stations", absolute);
    put(table, what.name + "_misfit_relative", "1", "root mean square of the deviation over the observation", relative);
  }
  return table;
}

io::Series curves_table(const Assimilation& a) {
  std::vector<double> id, steps;
  std::vector<std::vector<double>> values(a.observed.observables.size()), observed(values.size());
  for (std::size_t i = 0; i < a.ensemble.size(); ++i)
    for (Eigen::Index t = 0; t < a.runs.values[i].rows(); ++t) {
      id.push_back(static_cast<double>(a.ensemble.id[i]));
      steps.push_back(static_cast<double>(t + 1));
      for (std::size_t k = 0; k < values.size(); ++k) {
        values[k].push_back(a.runs.values[i](t, index(k)));
        observed[k].push_back(a.observed.values(t, index(k)));
      }
    }
  io::Series table;
  put(table, "id", "1", "number of the parameter set", id);
  put_station(table, a, steps);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Observable& what = a.observed.observables[k];
    put(table, what.name, what.unit, "value of the run at the station", std::move(values[k]));
    put(table, what.name + "_observed", what.unit, "observation", std::move(observed[k]));
  }
  return table;
}

/// Returns 1 / sum of w^2 / p over the sets whose runs are used, with weights p before and w after the observations.
double kept_share(const Vector& before, const Vector& weight, const Simulated& runs) {
  double used = 0, sum = 0;
  for (Eigen::Index i = 0; i < weight.size(); ++i) {
    const double p = std::exp(before[i]);
    if (runs.fate[static_cast<std::size_t>(i)] != Fate::used || !(p > 0)) continue;
    used += p;
    sum += weight[i] * weight[i] / p;
  }
  return 1 / (used * sum);
}

}  // namespace

Assimilation assimilate(Ensemble ensemble, Observations observed, Simulated runs, const ErrorModel& model,
                        std::optional<double> least_size, const std::vector<double>& stations, bool goes_on) {
  if (runs.used() == 0)
    throw DataError(fmt::format("none of {} runs can be used; the first: {}", runs.why.size(), runs.why.front()));
  Assimilation a{std::move(ensemble), std::move(observed), std::move(runs), {}, {}, {}, 0, {}};
  a.variance = variances(model, a.observed);
  a.misfit = misfits(a.observed, a.runs, a.variance);
  const Vector prior = goes_on ? a.ensemble.log_weight() : a.ensemble.log_prior_weight();
  a.filtered = least_size
                   ? filter_to_size(a.misfit, a.variance, prior, *least_size * static_cast<double>(a.ensemble.size()))
                   : filter(a.misfit, a.variance, prior);
  a.variance *= a.filtered.variance_factor;
  a.misfit /= a.filtered.variance_factor;
  const auto last = static_cast<Eigen::Index>(a.observed.stations()) - 1;
  for (const double at : stations) {
    const auto beyond = std::upper_bound(a.observed.at.begin(), a.observed.at.end(), at + 1e-9 * std::abs(at));
    const auto t = std::max<std::ptrdiff_t>(0, beyond - a.observed.at.begin() - 1);
    if (std::find(a.chosen.begin(), a.chosen.end(), t) == a.chosen.end()) a.chosen.push_back(t);
  }
  std::sort(a.chosen.begin(), a.chosen.end());
  if (a.chosen.empty()) a.chosen.push_back(last);
  a.ensemble.weight = a.filtered.weights(last);
  a.kept_share = kept_share(prior, a.ensemble.weight, a.runs);
  return a;
}

std::vector<std::string> assimilation_table_names() {
  return {"steps", "weights", "covariance", "density", "runs", "curves"};
}

std::vector<io::FieldsFile::Group> groups_of(const Assimilation& a) {
  return {{"steps", "weighted means and their like, one row per observation", steps_table(a)},
          {"weights", "weights, one row per parameter set", weights_table(a)},
          {"covariance", "covariance of the parameters at chosen steps", covariance_table(a)},
          {"density", "marginal posterior densities at chosen steps", density_table(a)},
          {"runs", "outcome of each run, one row per parameter set", runs_table(a)}};
}

io::Series table_of(const Assimilation& a, const std::vector<io::FieldsFile::Group>& groups, std::string_view name) {
  if (name == "curves") return curves_table(a);
  return std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group.name == name; })->table;
}

}  // namespace soilweave::calibration
