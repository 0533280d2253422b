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
  T inverse_distance;    // 1/m, of the centres; of the radius for a plane
};

/// The centres' relative velocity within the contact plane, m/s.
template <class T>
V3<T> transverse_velocity(const PairMotion<T>& m, const V3<T>& normal) {
  return fused_less(dot(m.velocity, normal), normal, m.velocity);
}

/// Increments over dt with full-radius levers and the translation amplified by (r1 + r2)/distance, which keeps a
/// contact from ratcheting when its overlap cycles (McNamara, Garcia-Rojo & Herrmann 2008; dem-laws §1). Normal,
/// overlap, radii and masses are the caller's.
template <class T>
void set_increments(const PairMotion<T>& m, const T& dt, Kinematics<T>& k) {
  const T translation = dt * ((m.lever_1 + m.lever_2) * m.inverse_distance);
  const T lever_1 = dt * m.lever_1, lever_2 = dt * m.lever_2;
  const V3<T> turning = fused(lever_2, m.spin_2, lever_1 * m.spin_1);
  const V3<T> turn = dt * (m.spin_2 - m.spin_1);
  k.approach_speed = -dot(m.velocity, k.normal);
  k.slip = fused(translation, transverse_velocity(m, k.normal), cross(k.normal, turning));
  k.twist = dot(turn, k.normal);
  k.roll = fused_less(k.twist, k.normal, turn);
}

/// What the increments above count beyond the slip of the grains' surfaces at the contact point, which lies half the
/// overlap inside each, over dt, m: the work of the shear force on it is the law's own.
template <class T>
V3<T> excess_slip(const PairMotion<T>& m, const Kinematics<T>& k, const T& dt) {
  const T time = dt * k.overlap;
  const V3<T> turning = (0.5 * time) * cross(k.normal, m.spin_1 + m.spin_2);
  return fused(T(time * m.inverse_distance), transverse_velocity(m, k.normal), turning);
}

}  // namespace soilweave::dem
