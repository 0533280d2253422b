// Sequential importance sampling, step by step in logs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/particle_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "core/text/units.h"

namespace soilweave::calibration {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double least_share = 0.01;  // least deviation near zero, as a share of the greatest observation

/// Returns the smallest effective size of all steps.
double smallest_size(const Matrix& misfit, const Vector& log_prior, double factor) {
  Vector logs = log_prior;
  double least = infinite;
  for (Eigen::Index t = 0; t < misfit.cols(); ++t) {
    logs -= misfit.col(t) / (2 * factor);
    logs.array() -= log_sum(logs);
    least = std::min(least, effective_size(exponentials(logs)));
  }
  return least;
}

/// Returns whether both units have the same size, or both are dimensionless (per cent included).
bool one_unit(const std::string& a, const std::string& b) {
  const auto factor = [](const std::string& from, const std::string& to) {
    try {
      return unit_factor(from.empty() ? "1" : from, to.empty() ? "1" : to);
    } catch (const DataError&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  };
  return a == b || factor(a, b) == 1 || (std::isfinite(factor(a, "1")) && std::isfinite(factor(b, "1")));
}

/// Throws DataError if observables differ in unit: one error for all of them would depend on the units chosen.
void demand_one_unit(const std::vector<Observable>& observables) {
  const Observable& first = observables.front();
  const auto unit = [](const Observable& what) { return what.unit.empty() ? "1" : what.unit; };
  for (const Observable& other : observables)
    if (!one_unit(first.unit, other.unit))
      throw DataError(fmt::format(
          "{} is in {} and {} in {}: one error for both would mean another thing in other units; give --covariance "
          "component with an error for each, or --covariance largest with a share, as --error 0.05",
          first.name, unit(first), other.name, unit(other)));
}

}  // namespace

ErrorModel::Kind error_kind(std::string_view name) {
  using enum ErrorModel::Kind;
  return name == "component" ? component : name == "relative" ? relative : name == "largest" ? largest : uniform;
}

Matrix variances(const ErrorModel& model, const Observations& observed) {
  using enum ErrorModel::Kind;
  const Eigen::Index steps = observed.values.rows(), components = observed.values.cols();
  if (model.kind == component) {
    if (static_cast<Eigen::Index>(model.size.size()) != components)
      throw DataError(fmt::format("errors: {} for {} observables; give one for each", model.size.size(), components));
    return Eigen::Map<const Vector>(model.size.data(), components).transpose().replicate(steps, 1);
  }
  if (model.size.size() != 1)
    throw DataError(fmt::format("errors: {} given; one is needed, or --covariance component", model.size.size()));
  if (model.kind == uniform) {
    demand_one_unit(observed.observables);
    return Matrix::Constant(steps, components, model.size.front());
  }
  Matrix deviation(steps, components);
  for (Eigen::Index c = 0; c < components; ++c) {
    const double greatest = observed.values.col(c).cwiseAbs().maxCoeff();
    if (!(greatest > 0))
      throw DataError(
          fmt::format("{} is zero at every station; an error relative to it is none: use --covariance component",
                      observed.observables[static_cast<std::size_t>(c)].name));
    deviation.col(c) = model.kind == largest
                           ? Vector::Constant(steps, greatest)
                           : Vector(observed.values.col(c).cwiseAbs().cwiseMax(least_share * greatest));
  }
  return (model.size.front() * deviation).array().square();
}

Matrix misfits(const Observations& observed, const Simulated& runs, const Matrix& variance) {
  const auto members = static_cast<Eigen::Index>(runs.values.size());
  Matrix misfit = Matrix::Constant(members, observed.values.rows(), infinite);
  for (Eigen::Index i = 0; i < members; ++i) {
    const Matrix& run = runs.values[static_cast<std::size_t>(i)];
    if (run.size() == 0) continue;
    misfit.row(i) = ((observed.values - run).array().square() / variance.array()).rowwise().sum().matrix().transpose();
  }
  return misfit;
}

Vector Filtered::weights(Eigen::Index step) const { return exponentials(log_weight.col(step)); }

Vector exponentials(const Vector& logs) {
  return logs.unaryExpr([](double x) { return std::exp(x); });
}

double log_sum(const Vector& logs) {
  const double largest = logs.maxCoeff();
  if (!(largest > -infinite)) return -infinite;
  return largest + std::log(exponentials(logs.array() - largest).sum());
}

double effective_size(const Vector& weight) { return 1 / weight.squaredNorm(); }

Filtered filter(const Matrix& misfit, const Matrix& variance, const Vector& log_prior) {
  const Eigen::Index steps = misfit.cols();
  Filtered f;
  f.log_weight.resize(misfit.rows(), steps);
  f.effective_size.resize(steps);
  f.log_evidence.resize(steps);
  f.least_misfit.resize(steps);
  Vector logs = log_prior;
  double evidence = 0;
  for (Eigen::Index t = 0; t < steps; ++t) {
    f.least_misfit[t] = infinite;
    for (Eigen::Index i = 0; i < logs.size(); ++i)
      if (logs[i] > -infinite) f.least_misfit[t] = std::min(f.least_misfit[t], misfit(i, t));
    logs -= misfit.col(t) / 2;  // -inf - inf stays -inf
    const double sum = log_sum(logs);
    if (!(sum > -infinite))
      throw DataError(
          fmt::format("step {}: the likelihood of every run is zero; no run has finite values near the "
                      "observations: check units, observables and prior",
                      t + 1));
    evidence += sum - 0.5 * (2 * std::numbers::pi * variance.row(t).array()).log().sum();
    logs.array() -= sum;
    f.log_weight.col(t) = logs;
    f.effective_size[t] = effective_size(exponentials(logs));
    f.log_evidence[t] = evidence;
  }
  return f;
}

Filtered filter_to_size(const Matrix& misfit, const Matrix& variance, const Vector& log_prior, double least) {
  // The search runs from a factor that makes the largest misfit negligible down to one that leaves only the best
  // member.
  double high = 0;
  for (Eigen::Index k = 0; k < misfit.size(); ++k)
    if (std::isfinite(misfit.data()[k])) high = std::max(high, misfit.data()[k]);
  high *= 1e6 * static_cast<double>(misfit.cols());
  if (!(high > 0)) high = 1;
  if (!(smallest_size(misfit, log_prior, high) >= least))
    throw DataError(
        fmt::format("an effective sample size of {:.4g} is not reached by any observation error: the runs that "
                    "can be used give {:.4g} before any observation; ask for less",
                    least, smallest_size(misfit, log_prior, high)));
  double low = high * 1e-30;
  for (int k = 0; k < 200 && high / low > 1 + 1e-12; ++k) {
    const double middle = std::sqrt(low * high);
    (smallest_size(misfit, log_prior, middle) >= least ? high : low) = middle;
  }
  Filtered f = filter(misfit / high, variance * high, log_prior);
  f.variance_factor = high;
  return f;
}

}  // namespace soilweave::calibration
