// Distributions that an ensemble was drawn from, round after round, and the density of all rounds together. In the
// prior's coordinates, the unit cube, where the prior density is 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "calibration/prior.h"
#include "files/files.h"

namespace soilweave::calibration {

/// One Gaussian of a mixture, in the prior's coordinates.
struct Gaussian {
  double share;  // share in the mixture
  Vector mean;
  Matrix root;  // lower triangular, covariance = root root^T
};

/// Returns the log density of one Gaussian at a point.
double log_density(const Gaussian& gaussian, const Vector& point);
/// Stores log(share * density) of each Gaussian in `parts`. Returns the log of the sum.
double log_parts(const std::vector<Gaussian>& gaussians, const Vector& point, Vector& parts);

/// Gaussians and a share of the prior, cut off at the cube's faces.
struct CutMixture {
  std::vector<Gaussian> gaussians;  // empty: the prior
  double prior_share = 1;
  double inside = 1;  // probability inside the cube before the cut

  /// Returns the log density of a point in the cube.
  double log_density(const Vector& point) const;
};

/// One round of sampling: the distribution that its sets were drawn from, and their number.
struct Round {
  CutMixture from;
  std::size_t sets;  // number of drawn sets
};

/// Returns the log density that the sets of all rounds sample: the mean of the rounds' densities, weighted by their
/// numbers of sets. It is the balance heuristic of Veach & Guibas (1995); for rounds that follow one another, the
/// adaptive multiple importance sampling of Cornuet, Marin, Mira & Robert (2012).
double log_density(const std::vector<Round>& rounds, const Vector& point);

/// Returns one row per Gaussian: round, sets, prior_share, inside, share, mean_<i>, root_<i>_<j>. A round from the
/// prior has one row of share 0.
io::Series rounds_table(const std::vector<Round>& rounds, std::size_t dimension);
/// Reads that table. Throws DataError naming `where`.
std::vector<Round> rounds_from(const io::Series& table, std::size_t dimension, const std::string& where);

}  // namespace soilweave::calibration
