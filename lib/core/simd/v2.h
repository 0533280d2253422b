// Vectors of the plane, for one contact or several at once (lanes.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simd/lanes.h"

namespace soilweave {

/// Vector of the plane. A rotation in the plane is one number, about its normal.
template <class T>
struct V2 {
  T x, y;

  V2() = default;
  V2(const T& first, const T& second) : x(first), y(second) {}
  V2(const V2& v) : x(v.x), y(v.y) {}
  V2& operator=(const V2& v) {
    x = v.x, y = v.y;
    return *this;
  }
};

template <class T>
V2<T> operator+(const V2<T>& a, const V2<T>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class T>
V2<T> operator*(const T& s, const V2<T>& a) {
  return {s * a.x, s * a.y};
}
/// Returns a . b.
template <class T>
T dot(const V2<T>& a, const V2<T>& b) {
  return fused(a.y, b.y, T(a.x * b.x));
}
/// Returns the component of a x b along the normal of the plane.
template <class T>
T cross(const V2<T>& a, const V2<T>& b) {
  return fused(a.x, b.y, T(-(a.y * b.x)));
}
/// Returns s a + b.
template <class T>
V2<T> fused(const T& s, const V2<T>& a, const V2<T>& b) {
  return {fused(s, a.x, b.x), fused(s, a.y, b.y)};
}
/// Returns b - s a.
template <class T>
V2<T> fused_less(const T& s, const V2<T>& a, const V2<T>& b) {
  return {fused_less(s, a.x, b.x), fused_less(s, a.y, b.y)};
}
/// Returns v where the mask holds, and zero elsewhere.
template <class T>
V2<T> masked(const Mask<T>& mask, const V2<T>& v) {
  return {masked(mask, v.x), masked(mask, v.y)};
}
/// Returns |a|^2.
template <class T>
T norm2(const V2<T>& a) {
  return dot(a, a);
}

}  // namespace soilweave
