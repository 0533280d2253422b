// From the rows of two grains, or of a grain and a plane, to what a contact law is given. T is double or lanes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "dem/contact_kinematics.h"

namespace soilweave::dem {

/// Where two bodies are and how they move: body 2, its image in contact, relative to body 1.
template <class T>
struct Meeting {
  V3<T> branch, velocity;  // m, m/s
  V3<T> spin_1, spin_2;    // rad/s
  T r1, r2, m1, m2;        // m, kg
};

template <class T>
struct PairGeometry {
  Mask<T> touching;
  V3<T> branch;       // m, centre to centre
  T arm_1, arm_2;     // m, from the centres to the contact point
  T half_spin;        // rad, the grains' mean spin about the normal over the step
  V3<T> excess_slip;  // m, contact_kinematics.h
  PairMotion<T> motion;
  Kinematics<T> kinematics;
};

/// The velocity that the deforming cell adds to a pair: affine closing over the step, at the branch before the cell
/// moved, to first order in the step: (L - dt L^2) d.
struct AffineMotion {
  Mat3 gradient;
  bool deforming;

  AffineMotion(const Mat3& L, bool moving, double dt) : gradient(L - dt * (L * L)), deforming(moving) {}

  template <class T>
  V3<T> operator()(const V3<T>& d) const {
    const Mat3& g = gradient;
    const auto component = [&](int i) {
      return fused(all<T>(g(i, 2)), d.z, fused(all<T>(g(i, 1)), d.y, T(g(i, 0) * d.x)));
    };
    return {component(0), component(1), component(2)};
  }
};

/// What two grains are to each other. Where they do not touch the overlap is zero.
template <class T>
void approach(const Meeting<T>& m, const AffineMotion& affine, PairGeometry<T>& g) {
  g.branch = m.branch;
  const T reach = m.r1 + m.r2, distance_squared = norm2(m.branch);
  g.touching = distance_squared <= reach * reach;
  const T distance = square_root(distance_squared), inverse = 1.0 / (distance * reach);
  PairMotion<T>& motion = g.motion;
  motion.velocity = affine.deforming ? m.velocity + affine(m.branch) : m.velocity;
  motion.spin_1 = m.spin_1, motion.spin_2 = m.spin_2;
  motion.lever_1 = m.r1, motion.lever_2 = m.r2;
  motion.inverse_distance = reach * inverse;
  Kinematics<T>& k = g.kinematics;
  k.normal = motion.inverse_distance * m.branch;
  k.overlap = keep(g.touching, reach - distance);
  k.r1 = m.r1, k.r2 = m.r2;
  k.R_star = m.r1 * m.r2 * (distance * inverse);
  k.m1 = m.m1, k.m2 = m.m2;
}

/// What follows for the step between two grains; increments are zero where they do not touch.
template <class T>
void increments(const T& dt, PairGeometry<T>& g) {
  const PairMotion<T>& motion = g.motion;
  Kinematics<T>& k = g.kinematics;
  set_increments(motion, dt, k);
  k.slip = keep(g.touching, k.slip), k.roll = keep(g.touching, k.roll), k.twist = keep(g.touching, k.twist);
  k.approach_speed = keep(g.touching, k.approach_speed);
  g.arm_1 = fused(all<T>(-0.5), k.overlap, k.r1), g.arm_2 = fused(all<T>(-0.5), k.overlap, k.r2);
  g.half_spin = 0.5 * dt * dot(k.normal, motion.spin_1 + motion.spin_2);
  g.excess_slip = excess_slip(motion, k, dt);
}

/// A grain and a plane, its inward normal; branch and velocity are the plane's, those of the foot of the perpendicular.
/// Levers are the full radius, for slip and torque alike: work-conjugate, and the rigid-body limit of the benchmarks.
inline PairGeometry<double> plane_geometry(const Meeting<double>& m, double height, const V3<double>& inward,
                                           double dt) {
  PairGeometry<double> g;
  g.touching = m.r1 - height >= 0;
  PairMotion<double>& motion = g.motion;
  motion.velocity = m.velocity;
  motion.spin_1 = m.spin_1, motion.spin_2 = {0, 0, 0};
  motion.lever_1 = m.r1, motion.lever_2 = 0;
  motion.inverse_distance = 1 / m.r1;
  Kinematics<double>& k = g.kinematics;
  k.normal = -1.0 * inward;
  g.branch = height * k.normal;
  set_increments(motion, dt, k);
  k.overlap = m.r1 - height;
  k.r1 = k.r2 = k.R_star = m.r1;
  k.m1 = m.m1, k.m2 = std::numeric_limits<double>::infinity();
  g.arm_1 = m.r1, g.arm_2 = 0;
  g.half_spin = 0.5 * dt * dot(k.normal, m.spin_1);
  g.excess_slip = {0, 0, 0};
  return g;
}

}  // namespace soilweave::dem
