// Where the next parameter sets are drawn from: Gaussians around the posterior, with their density for the importance
// correction. All in the prior's coordinates, the unit cube, where the prior density is 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "calibration/ensemble.h"

namespace soilweave::calibration {

/// A mixture of Gaussians cut off at the cube's faces, and a share drawn from the prior, which bounds the importance
/// weights (a defensive mixture: Hesterberg 1995).
class Proposal {
 public:
  /// One Gaussian about each member with weight; covariance that of the whole times Silverman's (1986) factor squared.
  static Proposal kernels(const Matrix& points, const Vector& weight, double prior_share);
  /// Up to `most` Gaussians fitted by expectation maximisation with weights; their number by the least Bayesian
  /// information criterion, with the effective sample size in place of the number of points.
  static Proposal mixture(const Matrix& points, const Vector& weight, std::size_t most, double prior_share);

  /// Points, a row each, from a Sobol sequence shifted at random by the seed. The same seed gives the same points.
  Matrix draw(std::size_t rows, std::uint64_t seed) const;
  /// What it is: its Gaussians, its density.
  const CutMixture& law() const { return law_; }

 private:
  Proposal(std::vector<Gaussian> gaussians, double prior_share);
  /// A point, maybe outside of the cube, from one of the unit cube with a dimension more: the first chooses the part.
  Vector drawn(const Vector& uniform) const;

  CutMixture law_;
};

/// Weights raised to the greatest power not above 1 that leaves an effective size of `least`, as far as there are as
/// many members with weight. A proposal made from them is wide enough though the posterior has degenerated; what it is
/// not is corrected by importance.
Vector tempered(const Vector& weight, double least, double& power);

/// `rows` members drawn from the proposal, a round of their own, numbered from first_id, with their importance.
Ensemble members_from(const Proposal& proposal, const Prior& prior, std::size_t rows, std::uint64_t seed,
                      std::int64_t first_id);

/// Both together: the members of rounds that followed from one another, each with the importance it has in a sample of
/// all of them (log_density of rounds.h), without weights. Both must know their rounds.
Ensemble together(const Ensemble& earlier, const Ensemble& next);

}  // namespace soilweave::calibration
