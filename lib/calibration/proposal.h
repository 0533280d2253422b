// Proposal of the next parameter sets: Gaussians around the posterior, with their density for the importance
// correction. All in the prior's coordinates, the unit cube, where the prior density is 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "calibration/ensemble.h"

namespace soilweave::calibration {

/// A mixture of Gaussians cut off at the cube's faces, plus a share of draws from the prior, which bounds the
/// importance weights (a defensive mixture: Hesterberg 1995).
class Proposal {
 public:
  /// Returns one Gaussian per member with weight. Its covariance is the whole one times Silverman's (1986) factor
  /// squared.
  static Proposal kernels(const Matrix& points, const Vector& weight, double prior_share);
  /// Returns up to `most` Gaussians, fitted by weighted expectation maximisation. Their number has the least Bayesian
  /// information criterion, with the effective sample size as the number of points.
  static Proposal mixture(const Matrix& points, const Vector& weight, std::size_t most, double prior_share);

  /// Returns points, one per row, from a Sobol sequence shifted at random by the seed. One seed gives the same points.
  Matrix draw(std::size_t rows, std::uint64_t seed) const;
  /// Returns the distribution: its Gaussians and its density.
  const CutMixture& law() const { return law_; }

 private:
  Proposal(std::vector<Gaussian> gaussians, double prior_share);
  /// Returns a point, perhaps outside the cube, from a point of the unit cube with one dimension more, whose first
  /// coordinate chooses the Gaussian.
  Vector drawn(const Vector& uniform) const;

  CutMixture law_;
};

/// Returns the weights raised to the greatest power <= 1 with an effective size of `least`, if as many members have
/// weight. A proposal from them is wide enough even for a degenerate posterior; importance corrects the difference.
Vector tempered(const Vector& weight, double least, double& power);

/// Returns `rows` members drawn from the proposal as a new round, numbered from first_id, with their importance.
Ensemble members_from(const Proposal& proposal, const Prior& prior, std::size_t rows, std::uint64_t seed,
                      std::int64_t first_id);

/// Joins rounds that follow one another, without weights. Each member gets its importance in a sample of all rounds
/// (log_density of rounds.h). Both ensembles must know their rounds.
Ensemble together(const Ensemble& earlier, const Ensemble& next);

}  // namespace soilweave::calibration
