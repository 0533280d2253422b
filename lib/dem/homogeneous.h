// A homogeneous field of velocity, laid over grains before plates start and taken out of them when plates stop.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plates that set off send a wave into grains of scaled density, and a second one when they stop: the grains at the
// plates move, those in the middle do not know yet. Where each grain is given the velocity v = L (x - c) that it would
// have if the assembly strained evenly, c being the centre of mass, no wave leaves the plates. When they stop, the
// gradient L that fits the grains best is found by least squares,
//   L = (sum m v x^T) (sum m x x^T)^-1,  x and v from the mean of all, weighted by mass,
// and its field is taken out again: what is left is what the grains do beside the mean strain. Since c is the centre of
// mass, momentum is neither given nor taken.
#pragma once

#include <array>
#include <vector>

#include "dem/simulation.h"

namespace soilweave::dem {

/// The axes along which a field may vary: those that are not periodic.
using OpenAxes = std::array<bool, 3>;

/// Moments about the centre of mass of the grains that are not held.
class HomogeneousField {
 public:
  /// held: grains that move as they are told, by number; they take no part.
  HomogeneousField(const Bodies& bodies, OpenAxes open, std::vector<bool> held);
  /// Takes all grains of a simulation but those in its clamps.
  explicit HomogeneousField(const Simulation& simulation);

  /// Gradient that fits the velocities best, 1/s, extension positive; zero along axes that are not open, and all zero
  /// where the grains do not span the open ones.
  Mat3 gradient(const Bodies& bodies) const;
  /// Adds v = L (x - c) to the velocities.
  void add(const Mat3& gradient, Bodies& bodies) const;
  /// Sum of m (x - c)^2 along each axis, kg m2; 0 along axes that are not open.
  Vec3 second_moments() const;

 private:
  OpenAxes open_;
  std::vector<bool> held_;
  double mass_ = 0;
  Vec3 centre_ = Vec3::Zero();
  Mat3 second_ = Mat3::Zero();
};

/// Frequency, 1/s, of the slowest swing of a homogeneous strain along an open axis: the root of the contacts' affine
/// stiffness, as it was last looked at, over the second moment of mass. 0 where nothing resists.
double slowest_swing(const Simulation& simulation);

}  // namespace soilweave::dem
