// From the motion of two bodies to the increments a contact law works with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/kinematics.h"

namespace soilweave::dem {

/// The motion of a pair over a step: body 2 relative to body 1.
template <class T, class Space = Spatial>
struct PairMotion {
  Vector<T, Space> velocity;      // m/s, of the centres
  Turn<T, Space> spin_1, spin_2;  // rad/s
  T lever_1, lever_2;             // m, the radii; 0 for a plane
  T inverse_distance;             // 1/m, of the centres; of the radius for a plane
};

/// What both turn the surfaces by, lengthwise: levers times spins, over dt.
template <class T, class Space>
Turn<T, Space> turning(const PairMotion<T, Space>& m, const T& dt) {
  const T lever_1 = dt * m.lever_1, lever_2 = dt * m.lever_2;
  return fused(lever_2, m.spin_2, Turn<T, Space>(lever_1 * m.spin_1));
}

/// Increments over dt with full-radius levers and the translation amplified by (r1 + r2)/distance, which keeps a
/// contact from ratcheting when its overlap cycles (McNamara, Garcia-Rojo & Herrmann 2008; dem-laws §1). Normal,
/// overlap, radii and masses are the caller's.
template <class T, class Space>
void set_increments(const PairMotion<T, Space>& m, const T& dt, Kinematics<T, Space>& k) {
  const T translation = dt * ((m.lever_1 + m.lever_2) * m.inverse_distance);
  const Turn<T, Space> turn = dt * (m.spin_2 - m.spin_1);
  k.approach_speed = -dot(m.velocity, k.normal);
  k.slip = fused(translation, along(k.normal, m.velocity), turned(k.normal, turning(m, dt)));
  if constexpr (Space::twists) {
    k.twist = dot(turn, k.normal);
    k.roll = fused_less(k.twist, k.normal, turn);
  } else {
    k.roll = turn;
  }
}

/// The slip of the grains' surfaces over dt at the contact point, which lies half the overlap inside each, m: what the
/// shear force does work on. The law's slip above has longer levers.
template <class T, class Space>
Along<T, Space> surface_slip(const PairMotion<T, Space>& m, const Kinematics<T, Space>& k, const T& dt) {
  const T depth = 0.5 * dt * k.overlap;
  const Turn<T, Space> spins = m.spin_1 + m.spin_2;
  return fused(dt, along(k.normal, m.velocity),
               turned(k.normal, Turn<T, Space>(fused_less(depth, spins, turning(m, dt)))));
}

}  // namespace soilweave::dem
