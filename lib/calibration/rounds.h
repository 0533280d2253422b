// What the members of an ensemble were drawn from, round after round, and the density of all of it together. In the
// prior's coordinates, the unit cube, where the prior density is 1.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "calibration/prior.h"
#include "io/files.h"

namespace soilweave::calibration {

struct Gaussian {
  double share;  // of the mixture
  Vector mean;
  Matrix root;  // lower triangular, covariance = root root^T
};

/// log density of one Gaussian at a point.
double log_density(const Gaussian& gaussian, const Vector& point);
/// log of share times density of each Gaussian into `parts`; returns that of their sum.
double log_parts(const std::vector<Gaussian>& gaussians, const Vector& point, Vector& parts);

/// Gaussians and a share of the prior, cut off at the cube's faces.
struct CutMixture {
  std::vector<Gaussian> gaussians;  // none: the prior
  double prior_share = 1;
  double inside = 1;  // how much of all that lies within the cube

  /// log density of a point in the cube.
  double log_density(const Vector& point) const;
};

struct Round {
  CutMixture from;
  std::size_t sets;  // drawn
};

/// log of the density that the sets of all rounds are a sample of: the mean of their densities, weighted by how many
/// sets each drew (the balance heuristic of Veach & Guibas 1995; over rounds that follow from one another, the adaptive
/// multiple importance sampling of Cornuet, Marin, Mira & Robert 2012).
double log_density(const std::vector<Round>& rounds, const Vector& point);

/// A row a Gaussian: round, sets, prior_share, inside, share, mean_<i>, root_<i>_<j>; a round from the prior has one
/// row of share 0.
io::Series rounds_table(const std::vector<Round>& rounds, std::size_t dimension);
/// Throws DataError, naming `where`.
std::vector<Round> rounds_from(const io::Series& table, std::size_t dimension, const std::string& where);

}  // namespace soilweave::calibration
