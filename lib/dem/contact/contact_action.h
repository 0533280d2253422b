// Action of a contact on its grains: force, torques, and stiffness.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "dem/contact/laws/contact.h"

namespace soilweave::dem {

/// Force and torques of a contact.
template <class T, class Space = Spatial>
struct Action {
  /// Force on the second body, N.
  Vector<T, Space> force;
  /// Torques, N m: the first body gets -torque_first, the second body torque_second.
  Turn<T, Space> torque_first, torque_second;
};

/// Returns force and torques. `arm_1`, `arm_2`: distances from centre to contact point, m.
template <class T, class Space>
Action<T, Space> action(const Vector<T, Space>& n, const T& arm_1, const T& arm_2,
                        const ContactHistory<T, Space>& history, const T& normal_force) {
  Turn<T, Space> free = history.rolling;
  if constexpr (Space::twists) free = fused(history.twisting, n, free);
  const Turn<T, Space> of_shear = moment(n, history.shear);
  return {joined(normal_force, n, history.shear), fused(arm_1, of_shear, free), fused_less(arm_2, of_shear, free)};
}

/// Returns the diagonals of a contact's stiffness matrices for translation and for rotation.
/// Source: Chareyre & Villard 2005 (LAWS.md §8).
template <class T>
std::pair<V3<T>, V3<T>> axis_stiffness(const V3<T>& n, const Response<T>& r, const T& radius) {
  const V3<T> n2{n.x * n.x, n.y * n.y, n.z * n.z}, one{broadcast<T>(1), broadcast<T>(1), broadcast<T>(1)};
  const T kr = r.rolling_stiffness + r.shear_stiffness * (radius * radius);
  return {r.shear_stiffness * one + (r.normal_stiffness - r.shear_stiffness) * n2,
          kr * one + (r.twisting_stiffness - kr) * n2};
}
template <class T>
std::pair<V2<T>, T> axis_stiffness(const V2<T>& n, const Response<T>& r, const T& radius) {
  const V2<T> n2{n.x * n.x, n.y * n.y}, one{broadcast<T>(1), broadcast<T>(1)};
  return {r.shear_stiffness * one + (r.normal_stiffness - r.shear_stiffness) * n2,
          r.rolling_stiffness + r.shear_stiffness * (radius * radius)};
}

/// Returns the stiffness of a contact against a stretch of the cell along each axis:
/// l_a^2 (kn n_a^2 + ks (1 - n_a^2)).
template <class T>
V2<T> affine_stiffness(const V2<T>& n, const T& length, const Response<T>& r) {
  const T ks = r.shear_stiffness, difference = r.normal_stiffness - ks, length2 = length * length;
  const auto along = [&](const T& n_a) { return T((length2 * (n_a * n_a)) * fused(difference, T(n_a * n_a), ks)); };
  return {along(n.x), along(n.y)};
}
template <class T>
V3<T> affine_stiffness(const V3<T>& n, const T& length, const Response<T>& r) {
  const V2<T> xy = affine_stiffness(V2<T>{n.x, n.y}, length, r);
  return {xy.x, xy.y, affine_stiffness(V2<T>{n.z, n.z}, length, r).x};
}

}  // namespace soilweave::dem
