// The memory of a contact turns with the pair: exactly, whatever the size of the rotation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/v3.h"

namespace soilweave::dem {

/// Carries vectors fixed to the contact plane from the old normal to the new one by the smallest rotation that maps one
/// on the other, then turns them about the new normal by spin_angle (rad, the grains' mean spin over the step). Length
/// is kept to round-off; the tangent of half the spin is exact to the seventh power of the angle. Valid while the
/// normal turns by less than half a turn in a step.
template <class T>
class Transport {
 public:
  Transport(const V3<T>& old_normal, const V3<T>& normal, const T& spin_angle)
      : normal_(normal), axis_(cross(old_normal, normal)), cosine_(dot(old_normal, normal)) {
    const T s2 = spin_angle * spin_angle;
    half_tangent_ = 0.5 * spin_angle * (1.0 + s2 * (1.0 / 12.0 + s2 * (1.0 / 120.0)));
    // One division for both scales.
    const T cayley = 1.0 + half_tangent_ * half_tangent_, rodrigues = 1.0 + cosine_;
    const T inverse = 1.0 / (cayley * rodrigues);
    along_ = cayley * inverse;
    turn_ = 2.0 * half_tangent_ * rodrigues * inverse;
  }

  V3<T> operator()(const V3<T>& f) const {
    // Rodrigues with axis a = n0 x n1 (length sin) and cosine c: g = c f + a x f + a (a.f)/(1 + c).
    const V3<T> g = fused(cosine_, f, fused(T(along_ * dot(axis_, f)), axis_, cross(axis_, f)));
    // Cayley form of the rotation about n by 2 atan t: g + 2/(1 + t^2) (t n x g + t^2 n x (n x g)).
    const V3<T> turned = cross(normal_, g);
    return fused(turn_, fused(half_tangent_, cross(normal_, turned), turned), g);
  }

 private:
  V3<T> normal_, axis_;
  T cosine_, half_tangent_, along_, turn_;
};

/// One vector carried so.
template <class T>
V3<T> transport(const V3<T>& f, const V3<T>& old_normal, const V3<T>& normal, const T& spin_angle) {
  return Transport<T>(old_normal, normal, spin_angle)(f);
}

}  // namespace soilweave::dem
