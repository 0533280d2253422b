// Vectors and second-order tensors, and their invariants in soil mechanics.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace soilweave {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec3i = Eigen::Vector3i;
/// Quaternion in the order w x y z.
using Vec4 = Eigen::Vector4d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

/// Returns tr(t) / dimension (2 or 3): the mean stress p if compression is positive.
inline double mean(const Mat3& t, int dimension = 3) {
  return t.topLeftCorner(dimension, dimension).trace() / dimension;
}

/// Returns the symmetric part.
inline Mat3 symmetric(const Mat3& t) { return 0.5 * (t + t.transpose()); }

/// Returns the deviatoric part for dimension 2 or 3. Entries outside the plane are zero in 2D.
inline Mat3 deviator(const Mat3& t, int dimension = 3) {
  Mat3 d = t;
  d.diagonal().head(dimension).array() -= mean(t, dimension);
  return d;
}

/// Returns the deviatoric stress q: sqrt(3/2 s:s) in 3D, sqrt(1/2 s:s) in 2D.
/// s is the symmetric deviator. In 2D, q is half the difference of the principal stresses.
inline double deviatoric_stress(const Mat3& stress, int dimension = 3) {
  const Mat3 s = deviator(symmetric(stress), dimension);
  return std::sqrt((dimension == 3 ? 1.5 : 0.5) * s.squaredNorm());
}

}  // namespace soilweave
