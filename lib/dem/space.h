// What vectors and turns are in space, and in the plane of disks, where a vector has two parts and a turn has one. The
// same formulas serve both (core/v2.h, core/v3.h). What lies along a contact is a vector normal to its normal in space;
// in the plane there is one such direction, the normal turned by a right angle, and it is a number along that.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/v2.h"
#include "core/v3.h"

namespace soilweave::dem {

struct Spatial {
  template <class T>
  using Vector = V3<T>;
  template <class T>
  using Turn = V3<T>;
  template <class T>
  using Along = V3<T>;
  static constexpr bool twists = true;  // grains can turn about the normal of a contact
};

struct Planar {
  template <class T>
  using Vector = V2<T>;
  template <class T>
  using Turn = T;
  template <class T>
  using Along = T;
  static constexpr bool twists = false;
};

template <class T, class Space>
using Vector = typename Space::template Vector<T>;
template <class T, class Space>
using Turn = typename Space::template Turn<T>;
template <class T, class Space>
using Along = typename Space::template Along<T>;

/// Of a vector, what lies along a contact.
template <class T>
V3<T> along(const V3<T>& normal, const V3<T>& v) {
  return fused_less(dot(v, normal), normal, v);
}
template <class T>
T along(const V2<T>& normal, const V2<T>& v) {
  return cross(normal, v);
}

/// The normal times a turn, which lies along the contact.
template <class T>
V3<T> turned(const V3<T>& normal, const V3<T>& turn) {
  return cross(normal, turn);
}
template <class T>
T turned(const V2<T>&, const T& turn) {
  return -turn;
}

/// The normal times what lies along the contact, a turn.
template <class T>
V3<T> moment(const V3<T>& normal, const V3<T>& along) {
  return cross(normal, along);
}
template <class T>
T moment(const V2<T>&, const T& along) {
  return along;
}

/// So much of the normal, and what lies along the contact.
template <class T>
V3<T> joined(const T& of_normal, const V3<T>& normal, const V3<T>& along) {
  return fused(of_normal, normal, along);
}
template <class T>
V2<T> joined(const T& of_normal, const V2<T>& normal, const T& along) {
  return {fused_less(along, normal.y, T(of_normal * normal.x)), fused(along, normal.x, T(of_normal * normal.y))};
}

}  // namespace soilweave::dem
