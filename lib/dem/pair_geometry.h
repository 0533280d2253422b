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
  V3<T> branch;    // m, centre to centre
  T arm_1, arm_2;  // m, from the centres to the contact point
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
    return {g(0, 0) * d.x + g(0, 1) * d.y + g(0, 2) * d.z, g(1, 0) * d.x + g(1, 1) * d.y + g(1, 2) * d.z,
            g(2, 0) * d.x + g(2, 1) * d.y + g(2, 2) * d.z};
  }
};

/// Two grains; b's position is that of the image in contact. Where they do not touch, the rest is of no meaning.
template <class T>
PairGeometry<T> grain_geometry(const Partner<T>& a, const Partner<T>& b, const AffineMotion& affine, const T& dt) {
  PairGeometry<T> g;
  g.branch = b.position - a.position;
  const T reach = a.radius + b.radius, distance_squared = norm2(g.branch);
  g.touching = distance_squared <= reach * reach;
  const T distance = square_root(distance_squared), overlap = reach - distance;
  g.motion.velocity = b.velocity - a.velocity;
  if (affine.deforming) g.motion.velocity = g.motion.velocity + affine(g.branch);
  g.motion.spin_1 = a.spin, g.motion.spin_2 = b.spin;
  g.motion.lever_1 = a.radius, g.motion.lever_2 = b.radius;
  g.motion.distance = distance;
  g.motion.normal = (1.0 / distance) * g.branch;
  g.kinematics = pair_kinematics(g.motion, dt);
  g.kinematics.overlap = overlap;
  g.kinematics.r1 = a.radius, g.kinematics.r2 = b.radius;
  g.kinematics.R_star = a.radius * b.radius / reach;
  g.kinematics.m_star = a.mass * b.mass / (a.mass + b.mass);
  g.arm_1 = a.radius - 0.5 * overlap, g.arm_2 = b.radius - 0.5 * overlap;
  return g;
}

/// A grain and a plane with its point, inward normal and velocity. Levers are the full radius, for slip and torque
/// alike: work-conjugate, and the rigid-body limit of the benchmarks.
inline PairGeometry<double> plane_geometry(const Partner<double>& grain, const V3<double>& point,
                                           const V3<double>& inward, const V3<double>& velocity, double dt) {
  PairGeometry<double> g;
  const double height = dot(grain.position - point, inward);
  g.touching = grain.radius - height >= 0;
  g.motion.velocity = velocity - grain.velocity;
  g.motion.spin_1 = grain.spin, g.motion.spin_2 = {0, 0, 0};
  g.motion.lever_1 = grain.radius, g.motion.lever_2 = 0;
  g.motion.distance = grain.radius;
  g.motion.normal = -1.0 * inward;
  g.branch = height * g.motion.normal;
  g.kinematics = pair_kinematics(g.motion, dt);
  g.kinematics.overlap = grain.radius - height;
  g.kinematics.r1 = g.kinematics.r2 = g.kinematics.R_star = grain.radius;
  g.kinematics.m_star = grain.mass;
  g.arm_1 = grain.radius, g.arm_2 = 0;
  return g;
}

}  // namespace soilweave::dem
