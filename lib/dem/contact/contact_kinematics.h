// Increments for a contact law, from the motion of two bodies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/kinematics.h"

namespace soilweave::dem {

/// Motion of a pair over a step, body 2 relative to body 1.
template <class T, class Space = Spatial>
struct PairMotion {
  /// Relative velocity of the centres, m/s.
  Vector<T, Space> velocity;
  /// Spins, rad/s.
  Turn<T, Space> spin_1, spin_2;
  /// Radii as levers of the spins, m; 0 for a plane.
  T lever_1, lever_2;
  /// 1/(distance of the centres), for a plane 1/radius, 1/m.
  T inverse_distance;
};

/// Returns the sum of levers times spins over dt, m. Normal x this sum is the slip from rotation.
template <class T, class Space>
Turn<T, Space> turning(const PairMotion<T, Space>& m, const T& dt) {
  const T lever_1 = dt * m.lever_1, lever_2 = dt * m.lever_2;
  return fused(lever_2, m.spin_2, Turn<T, Space>(lever_1 * m.spin_1));
}

/// Sets the increments over dt. The caller sets normal, overlap, radii and masses.
/// Levers are full radii, and (r1 + r2)/distance multiplies the translation. So a contact does not ratchet
/// when its overlap cycles (McNamara, Garcia-Rojo & Herrmann 2008; LAWS.md §1).
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

/// Returns the slip over dt at the contact point, m, which lies half the overlap inside each grain.
/// The shear force does its work on this slip. The slip in Kinematics has longer levers.
template <class T, class Space>
Along<T, Space> surface_slip(const PairMotion<T, Space>& m, const Kinematics<T, Space>& k, const T& dt) {
  const T depth = 0.5 * dt * k.overlap;
  const Turn<T, Space> spins = m.spin_1 + m.spin_2;
  return fused(dt, along(k.normal, m.velocity),
               turned(k.normal, Turn<T, Space>(fused_less(depth, spins, turning(m, dt)))));
}

}  // namespace soilweave::dem
