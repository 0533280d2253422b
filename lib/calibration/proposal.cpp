// Proposal of the next parameter sets.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/proposal.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "calibration/particle_filter.h"
#include "calibration/posterior.h"
#include "calibration/sampling.h"
#include "core/linear_algebra.h"

namespace soilweave::calibration {
namespace {

constexpr double least_deviation = 1e-3;  // least deviation of a Gaussian along any axis, as a share of the range
constexpr std::size_t inside_draws = 1 << 14;
constexpr int iterations = 200;
constexpr double settled = 1e-8;  // relative change of the log likelihood

Matrix root_of(const Matrix& covariance) {
  const Matrix floor = least_deviation * least_deviation * Matrix::Identity(covariance.rows(), covariance.cols());
  return Cholesky(covariance + floor).lower();
}

bool in_cube(const Vector& point) { return (point.array() >= 0).all() && (point.array() <= 1).all(); }

/// Returns Gaussians to start from. The first mean is the heaviest member. Each next mean has the greatest weight times
/// squared distance to the means so far.
std::vector<Gaussian> started(const Matrix& points, const Vector& weight, std::size_t count) {
  const Matrix root = root_of(weighted_covariance(points, weight) / static_cast<double>(count));
  std::vector<Gaussian> start;
  Vector distance = Vector::Ones(points.rows());
  for (std::size_t k = 0; k < count; ++k) {
    Eigen::Index chosen = 0;
    (weight.array() * distance.array()).maxCoeff(&chosen);
    start.push_back({1.0 / static_cast<double>(count), points.row(chosen).transpose(), root});
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const double away = (points.row(i) - points.row(chosen)).squaredNorm();
      distance[i] = k == 0 ? away : std::min(distance[i], away);
    }
  }
  return start;
}

/// Fits by weighted expectation maximisation. Returns the weighted mean log likelihood.
double maximise(const Matrix& points, const Vector& weight, std::vector<Gaussian>& gaussians) {
  const Eigen::Index rows = points.rows();
  double before = -std::numeric_limits<double>::infinity(), now = before;
  Matrix belongs(rows, index(gaussians.size()));
  Vector parts;
  for (int step = 0; step < iterations; ++step) {
    now = 0;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double log_density = log_parts(gaussians, points.row(i).transpose(), parts);
      belongs.row(i) = weight[i] * exponentials(parts.array() - log_density).transpose();
      now += weight[i] * log_density;
    }
    if (std::abs(now - before) <= settled * (1 + std::abs(now))) break;
    before = now;
    for (std::size_t k = 0; k < gaussians.size(); ++k) {
      const double share = belongs.col(index(k)).sum();
      if (!(share > 0)) continue;
      const Vector part = belongs.col(index(k)) / share;
      gaussians[k] = {share, weighted_mean(points, part), root_of(weighted_covariance(points, part))};
    }
  }
  return now;
}

}  // namespace

Proposal::Proposal(std::vector<Gaussian> gaussians, double prior_share) : law_{std::move(gaussians), prior_share, 1} {
  const Matrix uniform = sobol(inside_draws, static_cast<std::size_t>(law_.gaussians.front().mean.size()) + 1, 1);
  std::size_t hits = 0;
  for (Eigen::Index i = 0; i < uniform.rows(); ++i) hits += in_cube(drawn(uniform.row(i).transpose())) ? 1 : 0;
  law_.inside = static_cast<double>(std::max<std::size_t>(hits, 1)) / static_cast<double>(inside_draws);
}

Proposal Proposal::kernels(const Matrix& points, const Vector& weight, double prior_share) {
  const double d = static_cast<double>(points.cols());
  const double factor = std::pow(4 / ((d + 2) * effective_size(weight)), 1 / (d + 4));
  const Matrix root = root_of(factor * factor * weighted_covariance(points, weight));
  std::vector<Gaussian> gaussians;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (weight[i] > 0) gaussians.push_back({weight[i], points.row(i).transpose(), root});
  return {std::move(gaussians), prior_share};
}

Proposal Proposal::mixture(const Matrix& points, const Vector& weight, std::size_t most, double prior_share) {
  const double d = static_cast<double>(points.cols()), size = effective_size(weight);
  std::vector<Gaussian> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t count = 1; count <= most; ++count) {
    const double unknowns = static_cast<double>(count) * (1 + d + d * (d + 1) / 2) - 1;
    if (count > 1 && unknowns >= size) break;
    std::vector<Gaussian> gaussians = started(points, weight, count);
    const double criterion = unknowns * std::log(size) - 2 * size * maximise(points, weight, gaussians);
    if (criterion < least) best = gaussians;
    least = std::min(least, criterion);
  }
  return {std::move(best), prior_share};
}

Vector Proposal::drawn(const Vector& uniform) const {
  const Eigen::Index dimension = uniform.size() - 1;
  if (uniform[0] < law_.prior_share) return uniform.tail(dimension);
  double left = (uniform[0] - law_.prior_share) / (1 - law_.prior_share);
  std::size_t k = 0;
  while (k + 1 < law_.gaussians.size() && left >= law_.gaussians[k].share) left -= law_.gaussians[k++].share;
  Vector z(dimension);
  constexpr double edge = 1e-12;
  for (Eigen::Index i = 0; i < dimension; ++i)
    z[i] = gsl_cdf_ugaussian_Pinv(std::clamp(uniform[i + 1], edge, 1 - edge));
  return law_.gaussians[k].mean + law_.gaussians[k].root * z;
}

Matrix Proposal::draw(std::size_t rows, std::uint64_t seed) const {
  const Eigen::Index dimension = law_.gaussians.front().mean.size();
  std::mt19937_64 engine(seed);
  Vector shift(dimension + 1);
  for (double& s : shift) s = static_cast<double>(engine() >> 11) * 0x1.0p-53;
  Matrix points(index(rows), dimension);
  const std::size_t batch = std::max<std::size_t>(rows, 64);
  std::size_t made = 0;
  for (std::uint64_t first = 1; made < rows; first += batch) {
    const Matrix sequence = sobol(batch, static_cast<std::size_t>(dimension) + 1, first);
    for (Eigen::Index i = 0; i < sequence.rows() && made < rows; ++i) {
      Vector uniform = sequence.row(i).transpose() + shift;
      uniform.array() -= uniform.array().floor().eval();
      const Vector point = drawn(uniform);
      if (in_cube(point)) points.row(index(made++)) = point.transpose();
    }
  }
  return points;
}

Vector tempered(const Vector& weight, double least, double& power) {
  const auto raised = [&](double by) {
    const Vector w = (weight / weight.maxCoeff()).unaryExpr([&](double v) { return v > 0 ? std::pow(v, by) : 0.0; });
    return Vector(w / w.sum());
  };
  const double wanted = std::min(least, static_cast<double>((weight.array() > 0).count()));
  double low = 0, high = 1;
  if (effective_size(raised(1)) >= wanted) low = 1;
  for (int k = 0; k < 60 && low < 1; ++k) {
    const double middle = (low + high) / 2;
    (effective_size(raised(middle)) >= wanted ? low : high) = middle;
  }
  power = low;
  return raised(low);
}

Ensemble members_from(const Proposal& proposal, const Prior& prior, std::size_t rows, std::uint64_t seed,
                      std::int64_t first_id) {
  const Matrix points = proposal.draw(rows, seed);
  Ensemble next = members_at(prior, points, first_id);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    next.log_importance[i] = -proposal.law().log_density(points.row(i).transpose());
  next.rounds = {{proposal.law(), rows}};
  return next;
}

Ensemble together(const Ensemble& earlier, const Ensemble& next) {
  Ensemble all = earlier;
  all.weight.resize(0);
  all.id.insert(all.id.end(), next.id.begin(), next.id.end());
  all.rounds.insert(all.rounds.end(), next.rounds.begin(), next.rounds.end());
  all.values.resize(index(all.size()), earlier.values.cols());
  all.values << earlier.values, next.values;
  all.log_importance.resize(index(all.size()));
  const Matrix points = all.coordinates();
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    all.log_importance[i] = -log_density(all.rounds, points.row(i).transpose());
  return all;
}

}  // namespace soilweave::calibration
