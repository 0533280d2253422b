// The memory of a contact turns with the pair: exactly, whatever the size of the rotation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lanes.h"

namespace soilweave::dem {

/// A vector fixed to the contact plane, carried from the old normal to the new one by the smallest rotation that maps
/// one on the other, then turned about the new normal by spin_angle (rad, the grains' mean spin over the step). Length
/// is kept to round-off; the tangent of half the spin is exact to the seventh power of the angle. Valid while the
/// normal turns by less than half a turn in a step.
template <class T>
V3<T> transport(const V3<T>& f, const V3<T>& old_normal, const V3<T>& normal, const T& spin_angle) {
  // Rodrigues with axis a = n0 x n1 (length sin) and cosine c: f' = c f + a x f + a (a.f)/(1 + c).
  const V3<T> axis = cross(old_normal, normal);
  const T cosine = dot(old_normal, normal);
  const V3<T> g = cosine * f + cross(axis, f) + (dot(axis, f) / (1.0 + cosine)) * axis;
  const T s2 = spin_angle * spin_angle;
  const T t = 0.5 * spin_angle * (1.0 + s2 * (1.0 / 12.0 + s2 * (1.0 / 120.0)));
  // Cayley form of the rotation about n by 2 atan t: g' = g + 2/(1 + t^2) (t n x g + t^2 n x (n x g)).
  const V3<T> turn = cross(normal, g);
  const T scale = 2.0 * t / (1.0 + t * t);
  return g + scale * (turn + t * cross(normal, turn));
}

}  // namespace soilweave::dem
