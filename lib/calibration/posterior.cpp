// Moments, quantiles and densities of weighted parameters.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/posterior.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "calibration/particle_filter.h"

namespace soilweave::calibration {
namespace {

constexpr double narrowest = 0.01;             // bandwidth as a share of the range
constexpr double quartiles_of_normal = 1.349;  // their distance in standard deviations

}  // namespace

Vector weighted_mean(const Matrix& values, const Vector& weight) { return values.transpose() * weight; }

Matrix weighted_covariance(const Matrix& values, const Vector& weight) {
  const Matrix off = values.rowwise() - weighted_mean(values, weight).transpose();
  return off.transpose() * weight.asDiagonal() * off;
}

double weighted_quantile(const Vector& values, const Vector& weight, double share) {
  std::vector<Eigen::Index> order;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (weight[i] > 0) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
  double before = 0, last_middle = 0, last = values[order.front()];
  for (const Eigen::Index i : order) {
    const double middle = before + weight[i] / 2;
    if (middle >= share) {
      const double span = middle - last_middle;
      return span > 0 ? last + (values[i] - last) * (share - last_middle) / span : values[i];
    }
    before += weight[i];
    last_middle = middle;
    last = values[i];
  }
  return last;
}

Density marginal_density(const Range& range, const Vector& values, const Vector& weight, std::size_t points) {
  const Vector u = values.unaryExpr([&](double v) { return range.coordinate(v); });
  const double spread = std::sqrt(weighted_covariance(u, weight)(0, 0));
  const double quartiles = weighted_quantile(u, weight, 0.75) - weighted_quantile(u, weight, 0.25);
  const double scale = quartiles > 0 ? std::min(spread, quartiles / quartiles_of_normal) : spread;
  Density d;
  d.bandwidth = std::max(narrowest, 0.9 * scale * std::pow(effective_size(weight), -0.2));
  const double height = 1 / (d.bandwidth * std::sqrt(2 * std::numbers::pi) * range.width());
  const auto kernel = [&](double distance) { return std::exp(-0.5 * std::pow(distance / d.bandwidth, 2)); };
  for (std::size_t k = 0; k < points; ++k) {
    const double at = static_cast<double>(k) / static_cast<double>(points - 1);
    double sum = 0;
    for (Eigen::Index i = 0; i < u.size(); ++i)
      if (weight[i] > 0) sum += weight[i] * (kernel(at - u[i]) + kernel(at + u[i]) + kernel(2 - at - u[i]));
    d.value.push_back(range.value(at));
    d.density.push_back(height * sum);
  }
  return d;
}

}  // namespace soilweave::calibration
