// A homogeneous field of velocity, added before plates start and removed when they stop.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plates that start or stop send a wave into grains of scaled density. The wave is avoided if each grain gets the
// velocity v = L (x - c) of a homogeneous strain, where c is the centre of mass. When the plates stop, the best fit
//   L = (sum m v x^T) (sum m x x^T)^-1,  x and v relative to their means, weighted by mass,
// is removed. The grains keep their other motion, and momentum does not change.
#pragma once

#include <array>
#include <vector>

#include "dem/engine/simulation.h"

namespace soilweave::dem {

/// Axes along which a field may vary: the aperiodic ones.
using OpenAxes = std::array<bool, 3>;

/// Moments about the centre of mass of the grains that are not held.
class HomogeneousField {
 public:
  /// `held`: whether each grain has a prescribed motion and takes no part.
  HomogeneousField(const Bodies& bodies, OpenAxes open, std::vector<bool> held);
  /// Takes all grains of a simulation except those in its clamps.
  explicit HomogeneousField(const Simulation& simulation);

  /// Returns the gradient that fits the velocities best, 1/s, extension positive.
  /// The gradient is zero along periodic axes, and wholly zero if the grains do not span the aperiodic ones.
  Mat3 gradient(const Bodies& bodies) const;
  /// Adds v = L (x - c) to the velocities.
  void add(const Mat3& gradient, Bodies& bodies) const;
  /// Returns the sum of m (x - c)^2 along each axis, kg m2; 0 along axes that are not open.
  Vec3 second_moments() const;

 private:
  /// Axes along which the field varies.
  OpenAxes open_;
  /// Whether each grain takes no part.
  std::vector<bool> held_;
  /// Mass of these grains, kg.
  double mass_ = 0;
  /// Centre of mass, m.
  Vec3 centre_ = Vec3::Zero();
  /// Sum of m (x - c) (x - c)^T, kg m2.
  Mat3 second_ = Mat3::Zero();
};

/// Returns the frequency of the slowest swing of a homogeneous strain along an open axis, 1/s.
/// This is sqrt(affine stiffness, as last evaluated, over second moment of mass); 0 if nothing resists.
double slowest_swing(const Simulation& simulation);

}  // namespace soilweave::dem
