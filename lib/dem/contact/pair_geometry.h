// Geometry and motion of a pair of grains, or of a grain and a plane. T is double or lanes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "dem/contact/contact_kinematics.h"
#include "dem/contact/transport.h"

namespace soilweave::dem {

/// Input of the contact law for a pair. If the pair does not touch, overlap and increments are zero.
template <class T, class Space = Spatial>
struct PairGeometry {
  /// Motion as the law sees it.
  Kinematics<T, Space> kinematics;
  /// Slip of the surfaces, m (contact_kinematics.h).
  Along<T, Space> surface_slip;
  /// Gibbs vector of the history's rotation (transport.h); unused for disks.
  Turn<T, Space> turn;
  /// Whether the pair touches.
  Mask<T> touching;
};

/// Velocity that the deforming cell adds to a pair with branch d: (L - dt L^2) d.
/// To first order in the step, this is L times the branch before the cell moved.
struct AffineMotion {
  /// Gradient L - dt L^2 of the cell, 1/s.
  Mat3 gradient;
  /// Whether the cell deforms, and whether the gradient is diagonal.
  bool deforming, diagonal;

  AffineMotion(const Mat3& L, bool moving, double dt)
      : gradient(L - dt * (L * L)), deforming(moving), diagonal(Mat3(gradient.diagonal().asDiagonal()) == gradient) {}

  template <class T>
  V3<T> operator()(const V3<T>& d) const {
    const Mat3& g = gradient;
    // A diagonal gradient needs no further products: adding zeros would change no bit.
    if (diagonal) return {g(0, 0) * d.x, g(1, 1) * d.y, g(2, 2) * d.z};
    const auto component = [&](int i) {
      return fused(broadcast<T>(g(i, 2)), d.z, fused(broadcast<T>(g(i, 1)), d.y, T(g(i, 0) * d.x)));
    };
    return {component(0), component(1), component(2)};
  }
  template <class T>
  V2<T> operator()(const V2<T>& d) const {
    const Mat3& g = gradient;
    if (diagonal) return {g(0, 0) * d.x, g(1, 1) * d.y};
    const auto component = [&](int i) { return fused(broadcast<T>(g(i, 1)), d.y, T(g(i, 0) * d.x)); };
    return {component(0), component(1)};
  }
};

/// Relative position of two grains.
template <class T, class Space>
struct RelativePosition {
  /// Unit vector from body 1 to body 2.
  Vector<T, Space> normal;
  /// Overlap, m; r1 r2 / (r1 + r2), m; 1/(r1 + r2), 1/m; 1/distance, 1/m.
  T overlap, R_star, per_reach, inverse_distance;
  /// Whether the grains touch.
  Mask<T> touching;
};

/// Returns the position from branch vector and radii.
template <class T, class Space>
RelativePosition<T, Space> relative_position(const Vector<T, Space>& branch, const T& r1, const T& r2) {
  const T reach = r1 + r2, distance_squared = norm2(branch);
  const Mask<T> touching = distance_squared <= reach * reach;
  // Dividing beside the root is faster than dividing after it.
  const T distance = square_root(distance_squared), inverse = 1.0 / (distance_squared * reach);
  const T inverse_distance = distance * (reach * inverse), per_reach = distance_squared * inverse;
  return {inverse_distance * branch, masked(touching, reach - distance),
          r1 * r2 * per_reach,       per_reach,
          inverse_distance,          touching};
}

/// Returns the position of a pair that acts across gaps up to `range`, m.
/// The overlap of a pair that is farther apart is set to -range.
template <class T, class Space>
RelativePosition<T, Space> relative_position(const Vector<T, Space>& branch, const T& r1, const T& r2, const T& range) {
  RelativePosition<T, Space> relative = relative_position<T, Space>(branch, r1, r2);
  const T reach = r1 + r2, distance = square_root(norm2(branch));
  relative.touching = distance <= reach + range;
  relative.overlap = select<T>(relative.touching, T(reach - distance), T(0.0 - range));
  return relative;
}

/// Adds the motion over the step dt to a geometry that has the relative position. The caller sets the masses.
template <class T, class Space>
void set_motion(const PairMotion<T, Space>& motion, double dt, PairGeometry<T, Space>& g) {
  Kinematics<T, Space>& k = g.kinematics;
  const T time = masked(g.touching, broadcast<T>(dt));
  set_increments(motion, time, k);
  g.surface_slip = surface_slip(motion, k, time);
  if constexpr (Space::twists) {
    const auto turn = between(motion.velocity, T(-k.approach_speed), motion.inverse_distance, k.normal, time);
    g.turn = then_spin(turn, k.normal, T(0.5 * time * dot(k.normal, motion.spin_1 + motion.spin_2)));
  }
  k.approach_speed = masked(g.touching, k.approach_speed);
}

/// Returns the geometry of a grain and a plane with a constant inward normal.
/// `velocity`: plane relative to grain. `listed`: mask of existing pairs. `range`: gap across which they act, m.
/// Slip and torque have the full radius as lever, so they are work-conjugate; for rigid grains this is exact.
template <class T>
PairGeometry<T> plane_geometry(const V3<T>& velocity, const V3<T>& spin, const T& radius, const T& mass,
                               const T& height, const V3<T>& inward, const Mask<T>& listed, double dt,
                               double range = 0) {
  const V3<T> zero{};
  const PairMotion<T> motion{velocity, spin, zero, radius, T{}, 1.0 / radius};
  PairGeometry<T> g;
  Kinematics<T>& k = g.kinematics;
  g.touching = listed & (range > 0 ? Mask<T>(radius + range >= height) : Mask<T>(radius >= height));
  const T time = masked(g.touching, broadcast<T>(dt));
  k.normal = -inward;
  set_increments(motion, time, k);
  k.approach_speed = masked(g.touching, k.approach_speed);
  k.overlap = select<T>(g.touching, T(radius - height), broadcast<T>(range > 0 ? -range : 0.0));
  k.r1 = k.r2 = k.R_star = radius;
  k.per_reach = 0.5 / radius;
  k.m1 = mass, k.m2 = broadcast<T>(std::numeric_limits<double>::infinity());
  g.surface_slip = k.slip;
  g.turn = then_spin(zero, k.normal, T(0.5 * time * dot(k.normal, spin)));
  return g;
}

}  // namespace soilweave::dem
