// Proposal of the next parameter sets, in the prior's coordinates (the unit cube).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "calibration/ensemble.h"

namespace soilweave::calibration {

/// Gaussians cut off at the cube's faces, and a share of the prior that bounds importance (defensive mixture:
/// Hesterberg 1995).
class Proposal {
 public:
  /// Returns one Gaussian per member with weight. Covariance: that of all members times the square of Silverman's
  /// (1986) factor.
  static Proposal kernels(const Matrix& points, const Vector& weight, double prior_share);
  /// Returns up to `most` Gaussians, fitted by weighted expectation maximisation. Their number minimises the Bayesian
  /// information criterion at the effective size.
  static Proposal mixture(const Matrix& points, const Vector& weight, std::size_t most, double prior_share);

  /// Returns points, one per row, from a Sobol sequence shifted by the seed.
  Matrix draw(std::size_t rows, std::uint64_t seed) const;
  /// Returns the distribution.
  const CutMixture& law() const { return law_; }

 private:
  Proposal(std::vector<Gaussian> gaussians, double prior_share);
  /// Returns a point, perhaps outside the cube. The first of the uniform coordinates chooses the Gaussian.
  Vector drawn(const Vector& uniform) const;

  CutMixture law_;
};

/// Returns the weights raised to the greatest power <= 1 at which their effective size is at least `least`, or the
/// number of members with weight if fewer. So even a degenerate posterior gives a wide proposal; importance corrects
/// the bias. power: receives the power.
Vector tempered(const Vector& weight, double least, double& power);

/// Returns `rows` members as a new round, numbered from first_id, with importance.
Ensemble members_from(const Proposal& proposal, const Prior& prior, std::size_t rows, std::uint64_t seed,
                      std::int64_t first_id);

/// Joins rounds in sequence, without weights. Importance is recomputed from the joint density of all rounds (rounds.h).
/// Both ensembles must know their rounds.
Ensemble together(const Ensemble& earlier, const Ensemble& next);

}  // namespace soilweave::calibration
