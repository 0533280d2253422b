// From the rows of two grains, or of a grain and a plane, to what a contact law is given. T is double or lanes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "dem/contact_kinematics.h"

namespace soilweave::dem {

/// What two bodies are to each other. Where they do not touch the overlap is zero.
template <class T>
struct Approach {
  Mask<T> touching;
  V3<T> normal;       // unit, from body 1 to body 2
  T overlap, R_star;  // m
  PairMotion<T> motion;
};

/// What a contact law and the sums over contacts are given.
template <class T>
struct PairGeometry {
  Kinematics<T> kinematics;
  T arm_1, arm_2;     // m, from the centres to the contact point
  T half_spin;        // rad, the grains' mean spin about the normal over the step
  V3<T> excess_slip;  // m, contact_kinematics.h
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
};

/// Fills in what follows from the branch vector and the radii, the levers of the motion.
template <class T>
void approach(const V3<T>& branch, Approach<T>& a) {
  const T &r1 = a.motion.lever_1, &r2 = a.motion.lever_2;
  const T reach = r1 + r2, distance_squared = norm2(branch);
  a.touching = distance_squared <= reach * reach;
  const T distance = square_root(distance_squared), inverse = 1.0 / (distance * reach);
  a.motion.inverse_distance = reach * inverse;
  a.normal = a.motion.inverse_distance * branch;
  a.overlap = keep(a.touching, reach - distance);
  a.R_star = r1 * r2 * (distance * inverse);
}

/// What follows for the step between two grains; increments are zero where they do not touch. Masses are the caller's.
template <class T>
PairGeometry<T> increments(const Approach<T>& a, double dt) {
  const PairMotion<T>& motion = a.motion;
  const T time = keep(a.touching, all<T>(dt));
  PairGeometry<T> g;
  Kinematics<T>& k = g.kinematics;
  k.normal = a.normal, k.overlap = a.overlap, k.R_star = a.R_star;
  k.r1 = motion.lever_1, k.r2 = motion.lever_2;
  set_increments(motion, time, k);
  k.approach_speed = keep(a.touching, k.approach_speed);
  const T depth = 0.5 * k.overlap;
  g.arm_1 = k.r1 - depth, g.arm_2 = k.r2 - depth;
  g.half_spin = 0.5 * time * dot(k.normal, motion.spin_1 + motion.spin_2);
  g.excess_slip = excess_slip(motion, k, time);
  return g;
}

/// A grain and a plane, its inward normal; velocity is the plane's relative to the grain's. Levers are the full radius,
/// for slip and torque alike: work-conjugate, and the rigid-body limit of the benchmarks.
inline PairGeometry<double> plane_geometry(const V3<double>& velocity, const V3<double>& spin, double radius,
                                           double mass, double height, const V3<double>& inward, double dt) {
  const PairMotion<double> motion{velocity, spin, {0, 0, 0}, radius, 0, 1 / radius};
  PairGeometry<double> g;
  Kinematics<double>& k = g.kinematics;
  k.normal = -1.0 * inward;
  set_increments(motion, dt, k);
  k.overlap = radius - height;
  k.r1 = k.r2 = k.R_star = radius;
  k.m1 = mass, k.m2 = std::numeric_limits<double>::infinity();
  g.arm_1 = radius, g.arm_2 = 0;
  g.half_spin = 0.5 * dt * dot(k.normal, spin);
  g.excess_slip = {0, 0, 0};
  return g;
}

}  // namespace soilweave::dem
