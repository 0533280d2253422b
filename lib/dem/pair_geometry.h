// From the rows of two grains, or of a grain and a plane, to what a contact law is given. T is double or lanes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact_kinematics.h"

namespace soilweave::dem {

/// One body's part in a contact.
template <class T>
struct Partner {
  V3<T> position, velocity, spin;
  T radius, mass;
};

template <class T>
struct PairGeometry {
  Mask<T> touching;
  V3<T> branch;       // m, centre to centre
  T arm_1, arm_2;     // m, from the centres to the contact point
  T half_spin;        // rad, the grains' mean spin about the normal over the step
  V3<T> excess_slip;  // m, contact_kinematics.h
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

/// Two grains; b's position is that of the image in contact. Where they do not touch, overlap and increments are zero.
template <class T>
PairGeometry<T> grain_geometry(const Partner<T>& a, const Partner<T>& b, const AffineMotion& affine, const T& dt) {
  PairGeometry<T> g;
  g.branch = b.position - a.position;
  const T reach = a.radius + b.radius, distance_squared = norm2(g.branch);
  g.touching = distance_squared <= reach * reach;
  const T distance = square_root(distance_squared), overlap = keep(g.touching, reach - distance);
  PairMotion<T> motion;
  motion.velocity = b.velocity - a.velocity;
  if (affine.deforming) motion.velocity = motion.velocity + affine(g.branch);
  motion.spin_1 = a.spin, motion.spin_2 = b.spin;
  motion.lever_1 = a.radius, motion.lever_2 = b.radius;
  motion.inverse_distance = 1.0 / distance;
  motion.normal = motion.inverse_distance * g.branch;
  Kinematics<T>& k = g.kinematics;
  k = pair_kinematics(motion, dt);
  k.slip = keep(g.touching, k.slip), k.roll = keep(g.touching, k.roll), k.twist = keep(g.touching, k.twist);
  k.approach_speed = keep(g.touching, k.approach_speed);
  k.overlap = overlap;
  k.r1 = a.radius, k.r2 = b.radius;
  k.R_star = a.radius * b.radius / reach;
  k.m_star = a.mass * b.mass / (a.mass + b.mass);
  g.arm_1 = fused(all<T>(-0.5), overlap, a.radius), g.arm_2 = fused(all<T>(-0.5), overlap, b.radius);
  g.half_spin = 0.5 * dt * dot(k.normal, a.spin + b.spin);
  g.excess_slip = excess_slip(motion, overlap, dt);
  return g;
}

/// A grain and a plane with its point, inward normal and velocity. Levers are the full radius, for slip and torque
/// alike: work-conjugate, and the rigid-body limit of the benchmarks.
inline PairGeometry<double> plane_geometry(const Partner<double>& grain, const V3<double>& point,
                                           const V3<double>& inward, const V3<double>& velocity, double dt) {
  PairGeometry<double> g;
  const double height = dot(grain.position - point, inward);
  g.touching = grain.radius - height >= 0;
  PairMotion<double> motion;
  motion.velocity = velocity - grain.velocity;
  motion.spin_1 = grain.spin, motion.spin_2 = {0, 0, 0};
  motion.lever_1 = grain.radius, motion.lever_2 = 0;
  motion.inverse_distance = 1 / grain.radius;
  motion.normal = -1.0 * inward;
  g.branch = height * motion.normal;
  Kinematics<double>& k = g.kinematics;
  k = pair_kinematics(motion, dt);
  k.overlap = grain.radius - height;
  k.r1 = k.r2 = k.R_star = grain.radius;
  k.m_star = grain.mass;
  g.arm_1 = grain.radius, g.arm_2 = 0;
  g.half_spin = 0.5 * dt * dot(k.normal, grain.spin);
  g.excess_slip = {0, 0, 0};
  return g;
}

}  // namespace soilweave::dem
