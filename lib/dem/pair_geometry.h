// From the rows of two grains, or of a grain and a plane, to what a contact law is given. T is double or lanes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "dem/contact_kinematics.h"
#include "dem/transport.h"

namespace soilweave::dem {

/// What a contact law and the sums over contacts are given. Where two bodies do not touch, the overlap and all
/// increments are zero.
template <class T, class Space = Spatial>
struct PairGeometry {
  Kinematics<T, Space> kinematics;
  Along<T, Space> surface_slip;  // m, contact_kinematics.h
  // Gibbs vector that carries the memory (transport.h); what lies along a contact in the plane is carried as it is.
  Turn<T, Space> turn;
  Mask<T> touching;
};

/// The velocity that the deforming cell adds to a pair: affine closing over the step, at the branch before the cell
/// moved, to first order in the step: (L - dt L^2) d.
struct AffineMotion {
  Mat3 gradient;
  bool deforming, diagonal;

  AffineMotion(const Mat3& L, bool moving, double dt)
      : gradient(L - dt * (L * L)), deforming(moving), diagonal(Mat3(gradient.diagonal().asDiagonal()) == gradient) {}

  template <class T>
  V3<T> operator()(const V3<T>& d) const {
    const Mat3& g = gradient;
    if (diagonal) return {g(0, 0) * d.x, g(1, 1) * d.y, g(2, 2) * d.z};  // adding zeros would change no bit
    const auto component = [&](int i) {
      return fused(all<T>(g(i, 2)), d.z, fused(all<T>(g(i, 1)), d.y, T(g(i, 0) * d.x)));
    };
    return {component(0), component(1), component(2)};
  }
  template <class T>
  V2<T> operator()(const V2<T>& d) const {
    const Mat3& g = gradient;
    if (diagonal) return {g(0, 0) * d.x, g(1, 1) * d.y};
    const auto component = [&](int i) { return fused(all<T>(g(i, 1)), d.y, T(g(i, 0) * d.x)); };
    return {component(0), component(1)};
  }
};

/// Where two grains are to each other.
template <class T, class Space>
struct Place {
  Vector<T, Space> normal;
  T overlap, R_star, per_reach, inverse_distance;
  Mask<T> touching;
};

/// From the branch vector and their radii.
template <class T, class Space>
Place<T, Space> place_of(const Vector<T, Space>& branch, const T& r1, const T& r2) {
  const T reach = r1 + r2, distance_squared = norm2(branch);
  const Mask<T> touching = distance_squared <= reach * reach;
  // The division beside the root, not after it.
  const T distance = square_root(distance_squared), inverse = 1.0 / (distance_squared * reach);
  const T inverse_distance = distance * (reach * inverse), per_reach = distance_squared * inverse;
  return {inverse_distance * branch, keep(touching, reach - distance),
          r1 * r2 * per_reach,       per_reach,
          inverse_distance,          touching};
}

/// How they move, over a step dt that led there. Masses are the caller's.
template <class T, class Space>
void set_motion(const PairMotion<T, Space>& motion, double dt, PairGeometry<T, Space>& g) {
  Kinematics<T, Space>& k = g.kinematics;
  const T time = keep(g.touching, all<T>(dt));
  set_increments(motion, time, k);
  g.surface_slip = surface_slip(motion, k, time);
  if constexpr (Space::twists) {
    const auto turn = between(motion.velocity, T(-k.approach_speed), motion.inverse_distance, k.normal, time);
    g.turn = then_spin(turn, k.normal, T(0.5 * time * dot(k.normal, motion.spin_1 + motion.spin_2)));
  }
  k.approach_speed = keep(g.touching, k.approach_speed);
}

/// A grain and a plane, by its inward normal, which stays as it is; velocity is the plane's relative to the grain's.
/// Levers are the full radius, for slip and torque alike: work-conjugate, and the rigid-body limit of the benchmarks.
/// listed: where there is such a pair.
template <class T>
PairGeometry<T> plane_geometry(const V3<T>& velocity, const V3<T>& spin, const T& radius, const T& mass,
                               const T& height, const V3<T>& inward, const Mask<T>& listed, double dt) {
  const V3<T> zero{};
  const PairMotion<T> motion{velocity, spin, zero, radius, T{}, 1.0 / radius};
  PairGeometry<T> g;
  Kinematics<T>& k = g.kinematics;
  g.touching = listed & (radius >= height);
  const T time = keep(g.touching, all<T>(dt));
  k.normal = -inward;
  set_increments(motion, time, k);
  k.approach_speed = keep(g.touching, k.approach_speed);
  k.overlap = keep(g.touching, radius - height);
  k.r1 = k.r2 = k.R_star = radius;
  k.per_reach = 0.5 / radius;
  k.m1 = mass, k.m2 = all<T>(std::numeric_limits<double>::infinity());
  g.surface_slip = k.slip;
  g.turn = then_spin(zero, k.normal, T(0.5 * time * dot(k.normal, spin)));
  return g;
}

}  // namespace soilweave::dem
