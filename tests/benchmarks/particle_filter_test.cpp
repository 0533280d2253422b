// The particle filter on a linear model whose posterior is known in closed form.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/particle_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>

#include "calibration/posterior.h"
#include "calibration/sampling.h"
#include "support/calibration_reference.h"

namespace soilweave::calibration {
namespace {

using test::LinearModel;

TEST(ParticleFilter, ALinearModelHasItsExactPosteriorAndItsTruthInTheIntervals) {
  // 20 repetitions: means within four Monte Carlo errors, deviation / sqrt(effective size); variances within four of
  // theirs, sqrt(2 / size) relative. The true values lie inside the 90 % intervals in 18 of 20; 16 are asked.
  int inside[2] = {0, 0};
  for (std::uint64_t repetition = 0; repetition < 20; ++repetition) {
    const LinearModel model(100 + repetition, 0.25);
    const Assimilation a = model.assimilate(members_at(LinearModel::prior(2.5), sobol(20000, 2, 1)));
    const Vector& w = a.ensemble.weight;
    const double size = effective_size(w);
    ASSERT_GT(size, 50);
    const Vector mean = weighted_mean(a.ensemble.values, w);
    const Matrix covariance = weighted_covariance(a.ensemble.values, w);
    for (Eigen::Index k = 0; k < 2; ++k) {
      const double variance = model.covariance(k, k);
      EXPECT_NEAR(mean[k], model.mean[k], 4 * std::sqrt(variance / size));
      EXPECT_NEAR(covariance(k, k), variance, 4 * variance * std::sqrt(2 / size));
      const Vector values = a.ensemble.values.col(k);
      inside[k] +=
          weighted_quantile(values, w, 0.05) <= model.truth[k] && model.truth[k] <= weighted_quantile(values, w, 0.95);
    }
    EXPECT_NEAR(covariance(0, 1), model.covariance(0, 1),
                4 * std::sqrt(2 * model.covariance(0, 0) * model.covariance(1, 1) / size));
  }
  std::printf("[   info   ] true values inside the 90 %% intervals: %d and %d of 20\n", inside[0], inside[1]);
  EXPECT_GE(inside[0], 16);
  EXPECT_GE(inside[1], 16);
}

}  // namespace
}  // namespace soilweave::calibration
