// A homogeneous field of velocity: added to grains before plates start, removed when plates stop.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plates that start send a wave into grains of scaled density, and another when they stop, because the grains in the
// middle do not move yet. No wave leaves the plates if each grain gets the velocity v = L (x - c) that it would have if
// the assembly strained evenly; c is the centre of mass. When the plates stop, least squares gives the gradient L that
// fits the grains best,
//   L = (sum m v x^T) (sum m x x^T)^-1,  x and v from the mean of all, weighted by mass,
// and its field is removed. The grains keep the motion that differs from the mean strain. Since c is the centre of
// mass, momentum does not change.
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
  /// held: indices of grains with a prescribed motion, which take no part.
  HomogeneousField(const Bodies& bodies, OpenAxes open, std::vector<bool> held);
  /// Takes all grains of a simulation except those in its clamps.
  explicit HomogeneousField(const Simulation& simulation);

  /// Returns the gradient that fits the velocities best, 1/s, extension positive. Zero along axes that are not open,
  /// and zero altogether if the grains do not span the open ones.
  Mat3 gradient(const Bodies& bodies) const;
  /// Adds v = L (x - c) to the velocities.
  void add(const Mat3& gradient, Bodies& bodies) const;
  /// Returns the sum of m (x - c)^2 along each axis, kg m2; 0 along axes that are not open.
  Vec3 second_moments() const;

 private:
  OpenAxes open_;
  std::vector<bool> held_;
  /// Mass of these grains, kg.
  double mass_ = 0;
  /// Centre of mass, m.
  Vec3 centre_ = Vec3::Zero();
  /// Sum of m (x - c) (x - c)^T, kg m2.
  Mat3 second_ = Mat3::Zero();
};

/// Returns the frequency, 1/s, of the slowest swing of a homogeneous strain along an open axis: the root of the
/// contacts' affine stiffness, when last evaluated, over the second moment of mass. 0 if nothing resists.
double slowest_swing(const Simulation& simulation);

}  // namespace soilweave::dem
