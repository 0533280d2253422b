// Vectors and rotations in space, and in the plane of disks.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In the plane a vector has two components and a rotation one (core/simd).
// The shear force of disks is its component along the normal rotated by a right angle.
#pragma once

#include "core/simd/v2.h"
#include "core/simd/v3.h"

namespace soilweave::dem {

/// Types for spheres.
struct Spatial {
  template <class T>
  using Vector = V3<T>;
  template <class T>
  using Turn = V3<T>;
  template <class T>
  using Along = V3<T>;
  /// Grains can rotate about the normal of a contact.
  static constexpr bool twists = true;
};

/// Types for disks in the plane.
struct Planar {
  template <class T>
  using Vector = V2<T>;
  template <class T>
  using Turn = T;
  template <class T>
  using Along = T;
  static constexpr bool twists = false;
};

/// Position, velocity or force.
template <class T, class Space>
using Vector = typename Space::template Vector<T>;
/// Rotation, spin or torque.
template <class T, class Space>
using Turn = typename Space::template Turn<T>;
/// Vector normal to the contact normal, such as the shear force.
template <class T, class Space>
using Along = typename Space::template Along<T>;

/// Returns the part of a vector normal to the contact normal.
template <class T>
V3<T> along(const V3<T>& normal, const V3<T>& v) {
  return fused_less(dot(v, normal), normal, v);
}
template <class T>
T along(const V2<T>& normal, const V2<T>& v) {
  return cross(normal, v);
}

/// Returns normal x turn, which lies along the contact.
template <class T>
V3<T> turned(const V3<T>& normal, const V3<T>& turn) {
  return cross(normal, turn);
}
template <class T>
T turned(const V2<T>&, const T& turn) {
  return -turn;
}

/// Returns normal x (vector along the contact), such as the torque of the shear force over its arm.
template <class T>
V3<T> moment(const V3<T>& normal, const V3<T>& along) {
  return cross(normal, along);
}
template <class T>
T moment(const V2<T>&, const T& along) {
  return along;
}

/// Returns a multiple of the normal plus a vector along the contact.
template <class T>
V3<T> joined(const T& of_normal, const V3<T>& normal, const V3<T>& along) {
  return fused(of_normal, normal, along);
}
template <class T>
V2<T> joined(const T& of_normal, const V2<T>& normal, const T& along) {
  return {fused_less(along, normal.y, T(of_normal * normal.x)), fused(along, normal.x, T(of_normal * normal.y))};
}

}  // namespace soilweave::dem
