// The particle filter: the stored ensemble of thesis chapter 2, a linear model with a known posterior, hard cases.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/output/report.h"
#include "calibration/particle_filter.h"
#include "calibration/posterior.h"
#include "calibration/proposal.h"
#include "calibration/sampling.h"
#include "core/error.h"
#include "support/calibration_reference.h"
#include "support/reference.h"

namespace soilweave::calibration {
namespace {

using test::LinearModel;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns the 100 sets, their runs and the observations at 0.5 MPa; no members without reference data.
Assimilation stored_ensemble() {
  const auto sets = soilweave::test::reference_table("ch2/mc100_parameters.csv");
  const auto lines = soilweave::test::reference_table("ch2/mc100_simulations.csv");
  const auto lab = soilweave::test::reference_table("ch2/toyoura_obs_0.5MPa_100steps.csv");
  if (sets.empty()) return {};
  Ensemble ensemble;
  ensemble.prior = test::contact_prior({5.4e8, 0, 0.5, 0.1, 29}, {5.5e8, 0.2, 0.6, 0.2, 31});
  ensemble.values.resize(100, 5);
  ensemble.log_importance = Vector::Zero(100);
  const char* names[] = {"E_Pa", "nu", "kr", "eta", "mu_deg"};
  Simulated runs;
  for (std::size_t i = 0; i < 100; ++i) {
    ensemble.id.push_back(static_cast<std::int64_t>(i));
    for (std::size_t k = 0; k < 5; ++k)
      ensemble.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = sets.at(names[k])[i];
    runs.values.emplace_back(100, 3);
    runs.fate.push_back(Fate::used);
    runs.why.emplace_back();
  }
  Observations observed;
  observed.values.resize(100, 3);
  const char* columns[] = {"eps_r_pct", "stress_ratio", "eps_v_pct"};
  const char* observed_columns[] = {"eps_r_pct", "stress_ratio_sa_over_sr", "eps_v_pct"};
  for (std::size_t c = 0; c < 3; ++c) {
    observed.observables.push_back({columns[c], "1", {columns[c]}});
    for (std::size_t t = 0; t < 100; ++t)
      observed.values(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(c)) = lab.at(observed_columns[c])[t];
    for (std::size_t row = 0; row < 10000; ++row)
      runs.values[static_cast<std::size_t>(lines.at("sample")[row])](
          static_cast<Eigen::Index>(lines.at("step")[row]) - 1, static_cast<Eigen::Index>(c)) =
          lines.at(columns[c])[row];
  }
  for (std::size_t t = 0; t < 100; ++t) observed.at.push_back(static_cast<double>(t + 1));
  return assimilate(ensemble, observed, runs, {ErrorModel::Kind::uniform, {0.1}}, std::nullopt, {});
}

TEST(ParticleFilter, TheStoredEnsembleHasTheExpectedMeansAndWeights) {
  const Assimilation a = stored_ensemble();
  if (a.ensemble.id.empty()) GTEST_SKIP() << "SOILWEAVE_REFERENCE is not set";
  const auto means = soilweave::test::reference_table("ch2/mc100_expected_weighted_means_var0.1.csv");
  const auto weights = soilweave::test::reference_table("ch2/mc100_expected_weights_selected_steps.csv");
  const char* names[] = {"E_Pa", "nu", "kr", "eta", "mu_deg"};
  double farthest = 0, heaviest = 0;
  for (Eigen::Index t = 0; t < 100; ++t) {
    const Vector mean = weighted_mean(a.ensemble.values, a.filtered.weights(t));
    for (Eigen::Index k = 0; k < 5; ++k)
      farthest = std::max(farthest, std::abs(mean[k] / means.at(names[k])[static_cast<std::size_t>(t)] - 1));
  }
  for (const int step : {1, 10, 20, 40, 60, 80, 100})
    for (std::size_t i = 0; i < 100; ++i)
      heaviest = std::max(heaviest, std::abs(a.filtered.weights(step - 1)[static_cast<Eigen::Index>(i)] -
                                             weights.at("w_step" + std::to_string(step))[i]));
  std::printf("[   info   ] means to %.1e relative, weights to %.1e\n", farthest, heaviest);
  EXPECT_LT(farthest, 1e-6);
  EXPECT_LT(heaviest, 1e-4);
  EXPECT_NEAR(a.filtered.effective_size[99], 1.05, 0.01);
  const std::vector<Doubt> said = doubts(a);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].key, "degenerate");
  EXPECT_NE(said[0].sentence.find("0.973 of the weight is on member 50"), std::string::npos) << said[0].sentence;
}

TEST(ParticleFilter, WeightsAreProductsOfLikelihoods) {
  // Three members, two steps, by hand: chi2 of 0, 2, 4 and 2, 0, 4 with equal prior weights.
  Matrix misfit(3, 2);
  misfit << 0, 2, 2, 0, 4, 4;
  const Vector prior = Vector::Constant(3, -std::log(3.0));
  const Filtered f = filter(misfit, Matrix::Constant(2, 1, 1 / (2 * M_PI)), prior);
  const double sum = 1 + std::exp(-1) + std::exp(-2);
  EXPECT_NEAR(f.weights(0)[1], std::exp(-1) / sum, 1e-15);
  EXPECT_NEAR(f.weights(1)[0], f.weights(1)[1], 1e-15);
  EXPECT_NEAR(f.weights(1)[2] / f.weights(1)[0], std::exp(-3), 1e-15);
  EXPECT_NEAR(f.log_evidence[0], std::log(sum / 3), 1e-15);
  EXPECT_NEAR(f.log_evidence[1], std::log((2 * std::exp(-1) + std::exp(-4)) / 3), 1e-15);
}

TEST(ParticleFilter, MisfitsBeyondTheUnderflowStillRankAndGiveNoNan) {
  Matrix misfit(3, 2);
  misfit << 1e5, 1e6, 1e5 + 2, 1e6, infinite, infinite;
  const Filtered f = filter(misfit, Matrix::Ones(2, 1), Vector::Constant(3, -std::log(3.0)));
  EXPECT_NEAR(f.weights(1)[0], 1 / (1 + std::exp(-1)), 1e-10);
  EXPECT_EQ(f.weights(1)[2], 0);
  EXPECT_GT(f.least_misfit[0], underflow_misfit);
  EXPECT_THROW(filter(Matrix::Constant(2, 1, infinite), Matrix::Ones(1, 1), Vector::Zero(2)), DataError);
}

TEST(ParticleFilter, ABoundOnTheEffectiveSizeIsMetByTheSmallestError) {
  const LinearModel model(5);
  const Ensemble ensemble = members_at(LinearModel::prior(4), sobol(500, 2, 0));
  const Assimilation a =
      assimilate(ensemble, model.observed, model.run(ensemble), {ErrorModel::Kind::uniform, {1}}, 0.3, {});
  EXPECT_NEAR(a.filtered.effective_size.minCoeff(), 150, 0.01);
  const Assimilation same = assimilate(ensemble, model.observed, model.run(ensemble),
                                       {ErrorModel::Kind::uniform, {a.filtered.variance_factor}}, std::nullopt, {});
  EXPECT_LT((same.ensemble.weight - a.ensemble.weight).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((same.filtered.log_evidence - a.filtered.log_evidence).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((same.variance - a.variance).cwiseAbs().maxCoeff(), 1e-12 * same.variance.maxCoeff()) << "as it is told";
  EXPECT_LT((same.misfit - a.misfit).cwiseAbs().maxCoeff(), 1e-12 * same.misfit.maxCoeff());
  EXPECT_THROW(
      filter_to_size(Matrix::Constant(3, 1, infinite), Matrix::Ones(1, 1), Vector::Constant(3, -std::log(3.0)), 2),
      DataError);
}

TEST(ParticleFilter, EvidenceOfAScaledErrorIsThatOfTheScaledVariance) {
  // Two members with misfits 0 and 6 weigh 1 to w = exp(-3/f). The effective size (1 + w)^2 / (1 + w^2) is 1.6 for w =
  // 1/3, so f = 3 / log 3. The evidence is the mean likelihood under the variance f v.
  const Vector even = Vector::Constant(2, std::log(0.5));
  const Matrix misfit = (Matrix(2, 1) << 0, 6).finished();
  const double v = 0.04, f = 3 / std::log(3.0);
  const Filtered filtered = filter_to_size(misfit, Matrix::Constant(1, 1, v), even, 1.6);
  EXPECT_NEAR(filtered.variance_factor, f, 1e-9);
  EXPECT_NEAR(filtered.weights(0)[1], 0.25, 1e-9);
  EXPECT_NEAR(filtered.log_evidence[0], std::log(2.0 / 3) - 0.5 * std::log(2 * M_PI * f * v), 1e-9);
}

TEST(ParticleFilter, ErrorModelsGiveTheVariancesTheyName) {
  Observations observed;
  observed.at = {0, 1};
  observed.observables = {{"a", "1", {}}, {"b", "1", {}}};
  observed.values.resize(2, 2);
  observed.values << 0, -10, 2, 20;
  using enum ErrorModel::Kind;
  EXPECT_EQ(variances({uniform, {0.1}}, observed), Matrix::Constant(2, 2, 0.1));
  Matrix expected(2, 2);
  expected << 0.1, 0.2, 0.1, 0.2;
  EXPECT_EQ(variances({component, {0.1, 0.2}}, observed), expected);
  expected << 0.002, 1, 0.2, 2;  // a tenth of each; for an observation of 0, a tenth of 1 % of the greatest
  EXPECT_LT((variances({relative, {0.1}}, observed).cwiseSqrt() - expected).norm(), 1e-12);
  expected << 0.2, 2, 0.2, 2;
  EXPECT_LT((variances({largest, {0.1}}, observed).cwiseSqrt() - expected).norm(), 1e-12);
  EXPECT_THROW(variances({component, {0.1}}, observed), DataError);
  EXPECT_THROW(variances({uniform, {0.1, 0.2}}, observed), DataError);
  // One error for all is refused where it would depend on the units; names and signs of pure numbers are one.
  const auto taken = [&](const std::string& a, const std::string& b) {
    observed.observables[0].unit = a;
    observed.observables[1].unit = b;
    try {
      variances({uniform, {0.1}}, observed);
      return true;
    } catch (const DataError&) {
      return false;
    }
  };
  EXPECT_TRUE(taken("", "%") && taken("1", "%") && taken("kPa", "kN/m2") && taken("settlement", "settlement"));
  EXPECT_FALSE(taken("kPa", "MPa") || taken("kPa", "%") || taken("deg", "%") || taken("", "mm"));
}

TEST(ParticleFilter, EvidenceOfAFlatPriorIsOneOverItsVolumeTimesTheIntegral) {
  // One parameter, one observation y = 0.3 of variance 0.01, prior on [-2, 2]: the integral is 1, the evidence 1/4.
  const Prior prior{{{"a", "1", "", -2, 2, Scale::linear}}};
  const Ensemble ensemble = members_at(prior, sobol(4096, 1, 0));
  const Matrix misfit = (ensemble.values.array() - 0.3).square() / 0.01;
  const Filtered f = filter(misfit, Matrix::Constant(1, 1, 0.01), ensemble.log_prior_weight());
  EXPECT_NEAR(f.log_evidence[0], std::log(0.25), 1e-3);
}

TEST(Posterior, MomentsAndQuantilesOfWeights) {
  Matrix values(3, 2);
  values << 1, 10, 2, 30, 4, 20;
  const Vector weight = (Vector(3) << 0.5, 0.25, 0.25).finished();
  EXPECT_DOUBLE_EQ(weighted_mean(values, weight)[0], 2);
  EXPECT_DOUBLE_EQ(weighted_covariance(values, weight)(0, 0), 1.5);
  EXPECT_DOUBLE_EQ(weighted_covariance(values, weight)(0, 1), 0.5 * -1 * -7.5 + 0.25 * 0 + 0.25 * 2 * 2.5);
  // Middles of the members' weights at 0.25, 0.625, 0.875.
  EXPECT_DOUBLE_EQ(weighted_quantile(values.col(0), weight, 0.625), 2);
  EXPECT_DOUBLE_EQ(weighted_quantile(values.col(0), weight, 0.75), 3);
  EXPECT_DOUBLE_EQ(weighted_quantile(values.col(0), weight, 0.99), 4);
}

TEST(Posterior, ADensityIntegratesToOneAndIsTheNormalItCameFrom) {
  const Range range{"a", "1", "", 1, 100, Scale::log};
  const Matrix u = halton(4000, {2}, 1);
  Vector values(4000), weight(4000);
  for (Eigen::Index i = 0; i < 4000; ++i) {
    values[i] = range.value(u(i, 0));
    weight[i] = std::exp(-0.5 * std::pow((u(i, 0) - 0.4) / 0.1, 2));
  }
  weight /= weight.sum();
  const Density d = marginal_density(range, values, weight, 201);
  double integral = 0;
  for (std::size_t k = 1; k < 201; ++k)
    integral += 0.5 * (d.density[k] + d.density[k - 1]) * std::log10(d.value[k] / d.value[k - 1]);
  EXPECT_NEAR(integral, 1, 1e-6);
  // Two decades wide: 0.1 of the coordinate is 0.2 decades; the kernels widen it by their bandwidth.
  const double deviation = 2 * std::hypot(0.1, d.bandwidth);
  EXPECT_NEAR(d.density[80], 1 / (deviation * std::sqrt(2 * M_PI)), 0.01 / deviation);
}

TEST(Proposal, ImportanceMakesDrawsFromAnyProposalStandForThePrior) {
  // Expectations under the flat prior: mean 1/2, variance 1/12 of each coordinate.
  const Matrix points = halton(50, {2, 3}, 1) * 0.4;  // a corner of the square
  const Vector weight = Vector::Constant(50, 0.02);
  const Prior unit{{{"a", "1", "", 0, 1, Scale::linear}, {"b", "1", "", 0, 1, Scale::linear}}};
  for (const Proposal& proposal : {Proposal::kernels(points, weight, 0.2), Proposal::mixture(points, weight, 3, 0.2)}) {
    const Ensemble next = members_from(proposal, unit, 20000, 3, 50);
    EXPECT_EQ(next.id.front(), 50);
    EXPECT_TRUE((next.values.array() >= 0).all() && (next.values.array() <= 1).all());
    EXPECT_LT(weighted_mean(next.values, Vector::Constant(20000, 1.0 / 20000))[0], 0.4);
    const Vector w = next.log_prior_weight().array().exp();
    EXPECT_NEAR(weighted_mean(next.values, w)[0], 0.5, 0.01);
    EXPECT_NEAR(weighted_mean(next.values, w)[1], 0.5, 0.01);
    EXPECT_NEAR(weighted_covariance(next.values, w)(0, 0), 1.0 / 12, 0.002);
    // Densities integrate to one: the mean of 1/q over draws of q is the volume of the square.
    EXPECT_NEAR(next.log_importance.array().exp().mean(), 1, 0.02);
  }
}

TEST(Proposal, KernelsHaveSilvermansWidth) {
  // h = (4 / ((d + 2) n))^(1 / (d + 4)) times the deviation: of 50 even weights in the plane, h^2 = (1/50)^(1/3).
  const Matrix points = halton(50, {2, 3}, 1);
  const Vector even = Vector::Constant(50, 0.02);
  const CutMixture law = Proposal::kernels(points, even, 0.2).law();
  ASSERT_EQ(law.gaussians.size(), 50U);
  const Matrix expected =
      std::cbrt(1.0 / 50) * weighted_covariance(points, even) + 1e-6 * Matrix::Identity(2, 2);  // the least width
  for (const Gaussian& g : law.gaussians) {
    EXPECT_EQ(g.share, 0.02);
    EXPECT_LT((g.root * g.root.transpose() - expected).norm(), 1e-14);
  }
  EXPECT_EQ(law.prior_share, 0.2);
}

TEST(Rounds, DensityOfAGaussianIsTheTextbookS) {
  // Covariance [[4, 2], [2, 10]] = L L^T with L = [[2, 0], [1, 3]], determinant 36; at (2, 4) from the mean the form is
  // (10 * 4 - 2 * 2 * 8 + 4 * 16) / 36 = 2.
  const Gaussian g{1, Vector(Eigen::Vector2d(1, -1)), Matrix((Eigen::Matrix2d() << 2, 0, 1, 3).finished())};
  EXPECT_NEAR(log_density(g, Vector(Eigen::Vector2d(3, 3))), -1 - std::log(6.0) - std::log(2 * M_PI), 1e-14);
}

TEST(Proposal, TheNumberOfGaussiansFollowsThePoints) {
  Matrix points(400, 2);
  const Matrix u = halton(400, {2, 3}, 1);
  for (Eigen::Index i = 0; i < 400; ++i)  // two narrow clouds
    points.row(i) = (i % 2 == 0 ? 0.2 : 0.8) * Eigen::RowVector2d::Ones() + 0.05 * (u.row(i).array() - 0.5).matrix();
  const Proposal two = Proposal::mixture(points, Vector::Constant(400, 1.0 / 400), 5, 0);
  EXPECT_GE(two.law().gaussians.size(), 2u);
  EXPECT_LT(two.law().log_density(Eigen::Vector2d(0.5, 0.5)), -20);
  EXPECT_GT(two.law().log_density(Eigen::Vector2d(0.2, 0.2)), std::log(50));
}

TEST(Proposal, TemperingKeepsAsManySetsAsAsked) {
  Vector weight = Vector::LinSpaced(100, 0, -500).array().exp();
  weight /= weight.sum();
  double power = 0;
  EXPECT_NEAR(effective_size(tempered(weight, 30, power)), 30, 0.01);
  EXPECT_LT(power, 0.1);
  const Vector even = Vector::Constant(10, 0.1);
  EXPECT_EQ(tempered(even, 5, power), even);
  EXPECT_EQ(power, 1);
}

TEST(Proposal, ResamplingReachesTheExactPosteriorOfANarrowLikelihoodWithSixtyRunsARound) {
  // The posterior's deviations are about 1 % of the prior's range, which 60 sets of the first round miss.
  const auto resampled = [](bool kernel, bool keep) {
    const LinearModel model(42, 0.05);
    Ensemble ensemble = members_at(LinearModel::prior(4), sobol(60, 2, 1));
    Assimilation a = model.assimilate(ensemble);
    EXPECT_LT(a.filtered.effective_size[11], 3);
    for (std::uint64_t round = 1; round <= 3; ++round) {
      double power = 1;
      const Vector w = tempered(a.ensemble.weight, 6, power);
      const Matrix points = a.ensemble.coordinates();
      const Proposal proposal = kernel ? Proposal::kernels(points, w, 0.1) : Proposal::mixture(points, w, 5, 0.1);
      const Ensemble next = members_from(proposal, a.ensemble.prior, 60, round, 60 * static_cast<std::int64_t>(round));
      a = model.assimilate(keep ? together(a.ensemble, next) : next);
    }
    const double size = effective_size(a.ensemble.weight);
    const Vector mean = weighted_mean(a.ensemble.values, a.ensemble.weight);
    std::printf("[   info   ] %s%s: effective size after three rounds: %.3g of %zu\n", kernel ? "kernel" : "mixture",
                keep ? ", all rounds" : "", size, a.ensemble.size());
    EXPECT_GT(size, 10);
    for (Eigen::Index k = 0; k < 2; ++k)
      EXPECT_NEAR(mean[k], model.mean[k], 4 * std::sqrt(model.covariance(k, k) / size));
    return size;
  };
  // Four times the sets help, because the last round's sets count most.
  EXPECT_GT(resampled(false, true), 1.2 * resampled(false, false));
  EXPECT_GT(resampled(true, true), 1.2 * resampled(true, false));
}

TEST(Rounds, TogetherStandForThePriorWhateverEachWasDrawnFrom) {
  const Prior unit{{{"a", "1", "", 0, 1, Scale::linear}, {"b", "1", "", 0, 1, Scale::linear}}};
  const Vector even = Vector::Constant(50, 0.02);
  const Ensemble first = members_at(unit, sobol(500, 2, 1));
  // Without a share of the prior, only the first round covers the corners.
  const Proposal low = Proposal::kernels(halton(50, {2, 3}, 1) * 0.3, even, 0);
  const Proposal high = Proposal::mixture((halton(50, {2, 3}, 1) * 0.3).array() + 0.6, even, 3, 0);
  Ensemble all = together(first, members_from(low, unit, 3000, 1, 500));
  all = together(all, members_from(high, unit, 2500, 2, 3500));
  ASSERT_EQ(all.size(), 6000u);
  EXPECT_EQ(all.id.back(), 5999);
  EXPECT_EQ(all.weight.size(), 0);
  // Densities integrate to one, and expectations are the flat prior's.
  EXPECT_NEAR(all.log_importance.array().exp().mean(), 1, 0.02);
  const Vector w = all.log_prior_weight().array().exp();
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(weighted_mean(all.values, w)[k], 0.5, 0.015);
    EXPECT_NEAR(weighted_covariance(all.values, w)(k, k), 1.0 / 12, 0.003);
  }
  // The first round alone bounds every importance.
  EXPECT_LE(all.log_importance.maxCoeff(), std::log(6000.0 / 500) + 1e-12);
  // Rounds from the prior alone have no importance.
  const Ensemble twice = together(first, members_at(unit, sobol(300, 2, 501), 500));
  EXPECT_LT(twice.log_importance.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Rounds, GoThroughTablesUnchangedAndBrokenOnesAreRefused) {
  const Proposal proposal = Proposal::mixture(halton(50, {2, 3}, 1) * 0.4, Vector::Constant(50, 0.02), 3, 0.2);
  const std::vector<Round> rounds = {{{{}, 1, 1}, 500}, {proposal.law(), 60}, {{{}, 1, 1}, 7}, {proposal.law(), 40}};
  const io::Series table = rounds_table(rounds, 2);
  const std::vector<Round> read = rounds_from(table, 2, "here");
  ASSERT_EQ(read.size(), 4u);
  for (const Eigen::Vector2d& point : {Eigen::Vector2d(0.1, 0.3), Eigen::Vector2d(0.9, 0.2)})
    EXPECT_EQ(log_density(read, point), log_density(rounds, point));
  for (const char* name : {"round", "sets", "prior_share", "inside", "share", "mean_1", "root_1_1"})
    for (const double wrong : {std::nan(""), -1.0, infinite}) {
      if (name == std::string("mean_1") && wrong == -1) continue;
      io::Series broken = table;
      for (io::Column& column : broken.columns)
        if (column.name == name) column.values[1] = wrong;
      EXPECT_THROW(rounds_from(broken, 2, "here"), DataError) << name << " " << wrong;
    }
}

}  // namespace
}  // namespace soilweave::calibration
