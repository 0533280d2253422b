// Rotates the history of a contact with the pair.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simd/v3.h"

namespace soilweave::dem {

/// Returns 2/(1 + g2) by a series. Its error is of the fourth power of g2.
template <class T>
T small_scale(const T& g2) {
  const T two = broadcast<T>(2);
  return fused_less(g2, fused_less(g2, fused_less(g2, two, two), two), two);
}

/// Rotation v + 2/(1 + g^2) g x (v + g x v), which keeps lengths to rounding.
/// The Gibbs vector g is the axis times the tangent of half the angle (Rodrigues 1840).
template <class T>
class Rotation {
 public:
  explicit Rotation(const V3<T>& gibbs) : Rotation(gibbs, T(2.0 / (1.0 + norm2(gibbs)))) {}
  /// Returns the rotation by the series. Its error is of the eighth power of half the angle.
  static Rotation by_small(const V3<T>& gibbs) { return Rotation(gibbs, small_scale(norm2(gibbs))); }

  V3<T> operator()(const V3<T>& v) const { return add_cross(scaled_, add_cross(gibbs_, v, v), v); }

 private:
  Rotation(const V3<T>& gibbs, const T& scale) : gibbs_(gibbs), scaled_(scale * gibbs) {}

  /// Returns a x b + c.
  static V3<T> add_cross(const V3<T>& a, const V3<T>& b, const V3<T>& c) {
    return {fused_less(a.z, b.y, fused(a.y, b.z, c.x)), fused_less(a.x, b.z, fused(a.z, b.x, c.y)),
            fused_less(a.y, b.x, fused(a.x, b.y, c.z))};
  }

  V3<T> gibbs_, scaled_;
};

/// Returns the Gibbs vector of the smallest rotation between unit vectors that are not opposite.
template <class T>
V3<T> between(const V3<T>& old_normal, const V3<T>& normal) {
  return T(1.0 / (1.0 + dot(old_normal, normal))) * cross(old_normal, normal);
}

/// Returns the Gibbs vector of the rotation of a pair's normal over the step dt.
/// `velocity`: relative velocity, m/s. `parting`: its component along the normal, m/s.
/// Exact to the third power of displacement over distance.
template <class T, class V>
auto between(const V& velocity, const T& parting, const T& inverse_distance, const V& normal, const T& dt) {
  const T step = dt * inverse_distance, parted = step * parting, one = broadcast<T>(1);
  return T(0.5 * step * fused(parted, one + parted, one)) * cross(normal, velocity);
}

/// Returns the Gibbs vector of the rotation `gibbs`, about an axis in the contact plane, and then one about `normal`.
/// `angle`: angle of the second one, by the grains' mean spin, rad. tan(angle/2) is exact to the seventh power.
template <class T>
V3<T> then_spin(const V3<T>& gibbs, const V3<T>& normal, const T& angle) {
  const T s2 = angle * angle;
  const T t = 0.5 * angle * fused(s2, fused(s2, broadcast<T>(1.0 / 120.0), broadcast<T>(1.0 / 12.0)), broadcast<T>(1));
  return gibbs + t * (normal + cross(normal, gibbs));
}

/// Carries one vector from the old contact plane to the new one.
template <class T>
V3<T> transport(const V3<T>& f, const V3<T>& old_normal, const V3<T>& normal, const T& spin_angle) {
  return Rotation<T>(then_spin(between(old_normal, normal), normal, spin_angle))(f);
}

}  // namespace soilweave::dem
