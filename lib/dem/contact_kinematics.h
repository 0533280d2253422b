// From the motion of two bodies to the increments a contact law works with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/kinematics.h"

namespace soilweave::dem {

/// The motion of a pair over a step: body 2 relative to body 1.
template <class T>
struct PairMotion {
  V3<T> velocity;        // m/s, of the centres
  V3<T> spin_1, spin_2;  // rad/s
  T lever_1, lever_2;    // m, the radii; 0 for a plane
  T distance;            // m, between the centres; the radius for a plane
  V3<T> normal;          // unit, from 1 to 2
};

/// Slip velocity of the surfaces at levers l1 and l2, normal part removed, m/s.
template <class T>
V3<T> tangential_velocity(const PairMotion<T>& m, const T& l1, const T& l2) {
  const V3<T> v = m.velocity - cross(l2 * m.spin_2 + l1 * m.spin_1, m.normal);
  return v - dot(v, m.normal) * m.normal;
}

/// Increments over dt with full-radius levers and the translation amplified by (r1 + r2)/distance, which keeps a
/// contact from ratcheting when its overlap cycles (McNamara, Garcia-Rojo & Herrmann 2008; dem-laws §1). Overlap, radii
/// and mass are left to the caller.
template <class T>
Kinematics<T> pair_kinematics(const PairMotion<T>& m, const T& dt) {
  PairMotion<T> amplified = m;
  const T reach = m.lever_1 + m.lever_2;
  amplified.velocity = (reach / m.distance) * m.velocity;
  const V3<T> turn = dt * (m.spin_2 - m.spin_1);
  Kinematics<T> k;
  k.normal = m.normal;
  k.approach_speed = -dot(m.velocity, m.normal);
  k.slip = dt * tangential_velocity(amplified, m.lever_1, m.lever_2);
  k.twist = dot(turn, m.normal);
  k.roll = turn - k.twist * m.normal;
  return k;
}

}  // namespace soilweave::dem
