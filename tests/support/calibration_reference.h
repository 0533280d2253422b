// The parameters of thesis chapter 2, and a model whose posterior is known exactly, for the tests of calibration.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <random>
#include <string>
#include <vector>

#include "calibration/assimilation.h"

namespace soilweave::calibration::test {

/// Returns the prior of E on a log scale, nu, kr, eta and mu between the given values.
inline Prior contact_prior(const std::vector<double>& low, const std::vector<double>& high) {
  return {{{"E", "Pa", "", low[0], high[0], Scale::log},
           {"nu", "1", "", low[1], high[1], Scale::linear},
           {"kr", "1", "", low[2], high[2], Scale::linear},
           {"eta", "1", "", low[3], high[3], Scale::linear},
           {"mu", "deg", "", low[4], high[4], Scale::linear}}};
}

/// Model y_t = A_t theta + noise with two parameters, two observables and T steps. With a wide flat prior the posterior
/// is normal: covariance v (sum of A_t^T A_t)^-1, mean covariance sum of A_t^T y_t / v.
struct LinearModel {
  explicit LinearModel(std::uint64_t seed, double variance_ = 0.04, Eigen::Index steps = 12)
      : variance(variance_), random(seed) {
    for (Eigen::Index t = 0; t < steps; ++t) design.push_back(normal(2, 2));
    truth = 0.5 * normal(2, 1);
    Matrix information = Matrix::Zero(2, 2);
    Vector sum = Vector::Zero(2);
    observed.station = {"t", "1", {"t"}};
    observed.observables = {{"one", "1", {"one"}}, {"other", "1", {"other"}}};
    observed.values.resize(steps, 2);
    for (Eigen::Index t = 0; t < steps; ++t) {
      const Matrix& A = design[static_cast<std::size_t>(t)];
      const Vector y = A * truth + std::sqrt(variance) * normal(2, 1);
      observed.at.push_back(static_cast<double>(t));
      observed.values.row(t) = y.transpose();
      information += A.transpose() * A / variance;
      sum += A.transpose() * y / variance;
    }
    covariance = information.inverse();
    mean = covariance * sum;
  }

  Simulated run(const Ensemble& ensemble) const {
    Simulated runs;
    for (Eigen::Index i = 0; i < ensemble.values.rows(); ++i) {
      Matrix values(observed.values.rows(), 2);
      for (Eigen::Index t = 0; t < values.rows(); ++t)
        values.row(t) = (design[static_cast<std::size_t>(t)] * ensemble.values.row(i).transpose()).transpose();
      runs.values.push_back(values);
      runs.fate.push_back(Fate::used);
      runs.why.emplace_back();
    }
    return runs;
  }

  Assimilation assimilate(const Ensemble& ensemble) const {
    return calibration::assimilate(ensemble, observed, run(ensemble), {ErrorModel::Kind::uniform, {variance}},
                                   std::nullopt, {});
  }

  static Prior prior(double half_width) {
    return {{{"a", "1", "", -half_width, half_width, Scale::linear},
             {"b", "1", "", -half_width, half_width, Scale::linear}}};
  }

  double variance;
  Vector truth, mean;
  Matrix covariance;
  Observations observed;
  std::vector<Matrix> design;

 private:
  Matrix normal(Eigen::Index rows, Eigen::Index columns) {
    Matrix m(rows, columns);
    std::normal_distribution<double> one;
    for (Eigen::Index k = 0; k < m.size(); ++k) m.data()[k] = one(random);
    return m;
  }
  std::mt19937_64 random;
};

}  // namespace soilweave::calibration::test
