// The memory of a contact turns with the pair: exactly, whatever the size of the rotation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/v3.h"

namespace soilweave::dem {

/// Carries vectors of the contact plane, normal to the old normal, to the new one by the smallest rotation that maps
/// one normal on the other, then turns them about the new normal by spin_angle (rad, the grains' mean spin over the
/// step). Length is kept to round-off; the tangent of half the spin is exact to the seventh power of the angle. Valid
/// while the normal turns by less than half a turn in a step.
template <class T>
class Transport {
 public:
  Transport(const V3<T>& old_normal, const V3<T>& normal, const T& spin_angle)
      : normal_(normal), sum_(old_normal + normal) {
    const T s2 = spin_angle * spin_angle, one = all<T>(1);
    const T series = fused(s2, fused(s2, all<T>(1.0 / 120.0), all<T>(1.0 / 12.0)), one);
    const T t = 0.5 * spin_angle * series;  // tangent of half the spin
    // One division for both scales.
    const T length = fused(t, t, one), rodrigues = one + dot(old_normal, normal);
    const T inverse = one / (length * rodrigues);
    against_ = length * inverse;
    const T scale = rodrigues * inverse;
    cosine_ = fused_less(t, t, one) * scale;
    sine_ = (t + t) * scale;
  }

  V3<T> operator()(const V3<T>& f) const {
    // Rodrigues' rotation from n0 to n1 of a vector normal to n0: f - (f.n1)/(1 + n0.n1) (n0 + n1).
    const V3<T> g = fused_less(T(against_ * dot(f, normal_)), sum_, f);
    return fused(cosine_, g, sine_ * cross(normal_, g));
  }

 private:
  V3<T> normal_, sum_;
  T against_, cosine_, sine_;
};

/// One vector carried so.
template <class T>
V3<T> transport(const V3<T>& f, const V3<T>& old_normal, const V3<T>& normal, const T& spin_angle) {
  return Transport<T>(old_normal, normal, spin_angle)(f);
}

}  // namespace soilweave::dem
