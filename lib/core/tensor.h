// Vectors and second-order tensors, and the invariants soil mechanics reads off them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace soilweave {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec3i = Eigen::Vector3i;
using Vec4 = Eigen::Vector4d;  // quaternions, in the order w x y z
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

/// Mean of the diagonal over the space's dimension (2 or 3). For a compression-positive stress: the mean stress p.
inline double mean(const Mat3& t, int dimension = 3) {
  return t.topLeftCorner(dimension, dimension).trace() / dimension;
}

/// Symmetric part.
inline Mat3 symmetric(const Mat3& t) { return 0.5 * (t + t.transpose()); }

/// Deviatoric part, in the space's dimension (2 or 3); entries beyond it are left zero in 2D.
inline Mat3 deviator(const Mat3& t, int dimension = 3) {
  Mat3 d = t;
  d.diagonal().head(dimension).array() -= mean(t, dimension);
  return d;
}

/// Deviatoric stress q = sqrt(3/2 s:s) of the symmetric part in 3D, sqrt(1/2 s:s) in 2D (half the principal
/// difference).
inline double deviatoric_stress(const Mat3& stress, int dimension = 3) {
  const Mat3 s = deviator(symmetric(stress), dimension);
  return std::sqrt((dimension == 3 ? 1.5 : 0.5) * s.squaredNorm());
}

}  // namespace soilweave
