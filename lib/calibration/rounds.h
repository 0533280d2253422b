// Distributions of all rounds of sampling, and their joint density. Coordinates are the prior's, in the unit cube,
// where the prior density is 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "calibration/prior.h"
#include "files/files.h"

namespace soilweave::calibration {

/// One Gaussian of a mixture.
struct Gaussian {
  /// Share in the mixture.
  double share;
  Vector mean;
  /// Lower triangular; covariance = root root^T.
  Matrix root;
};

/// Returns the log density of one Gaussian at a point.
double log_density(const Gaussian& gaussian, const Vector& point);
/// Stores log(share * density) of each Gaussian in `parts`; returns the log of the sum.
double log_parts(const std::vector<Gaussian>& gaussians, const Vector& point, Vector& parts);

/// Gaussians and a share of the prior, cut off at the cube's faces.
struct CutMixture {
  /// Empty: the prior alone.
  std::vector<Gaussian> gaussians;
  double prior_share = 1;
  /// Probability inside the cube before the cut.
  double inside = 1;

  /// Returns the log density of a point in the cube.
  double log_density(const Vector& point) const;
};

/// One round of sampling.
struct Round {
  /// Distribution of the draws.
  CutMixture from;
  /// Number of drawn sets.
  std::size_t sets;
};

/// Returns the log density of all rounds together: their mean, weighted by numbers of sets. This is the balance
/// heuristic (Veach & Guibas 1995), and for rounds in sequence adaptive multiple importance sampling (Cornuet, Marin,
/// Mira & Robert 2012).
double log_density(const std::vector<Round>& rounds, const Vector& point);

/// Returns one row per Gaussian: round, sets, prior_share, inside, share, mean_<i>, root_<i>_<j>. A round from the
/// prior has one row of share 0.
io::Series rounds_table(const std::vector<Round>& rounds, std::size_t dimension);
/// Reads that table. Throws DataError naming `where`.
std::vector<Round> rounds_from(const io::Series& table, std::size_t dimension, const std::string& where);

}  // namespace soilweave::calibration
