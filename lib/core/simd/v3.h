// Vectors of space, for one contact or several at once (lanes.h), and rows of a vector and a scalar.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simd/lanes.h"
#include "core/tensor.h"

namespace soilweave {

/// Numbers are copied one by one, because the compiler then keeps them in registers.
template <class T>
struct V3 {
  T x, y, z;

  V3() = default;
  V3(const T& first, const T& second, const T& third) : x(first), y(second), z(third) {}
  V3(const V3& v) : x(v.x), y(v.y), z(v.z) {}
  V3& operator=(const V3& v) {
    x = v.x, y = v.y, z = v.z;
    return *this;
  }
};

template <class T>
V3<T> operator+(const V3<T>& a, const V3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
V3<T> operator-(const V3<T>& a, const V3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
V3<T> operator-(const V3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
V3<T> operator*(const T& s, const V3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
/// Returns `yes` in lanes where the mask holds, `no` elsewhere.
template <class T>
V3<T> select(const Mask<T>& mask, const V3<T>& yes, const V3<T>& no) {
  return {select<T>(mask, yes.x, no.x), select<T>(mask, yes.y, no.y), select<T>(mask, yes.z, no.z)};
}
/// Returns a . b.
template <class T>
T dot(const V3<T>& a, const V3<T>& b) {
  return fused(a.z, b.z, fused(a.y, b.y, T(a.x * b.x)));
}
/// Returns a x b.
template <class T>
V3<T> cross(const V3<T>& a, const V3<T>& b) {
  return {fused(a.y, b.z, T(-(a.z * b.y))), fused(a.z, b.x, T(-(a.x * b.z))), fused(a.x, b.y, T(-(a.y * b.x)))};
}
/// Returns s a + b.
template <class T>
V3<T> fused(const T& s, const V3<T>& a, const V3<T>& b) {
  return {fused(s, a.x, b.x), fused(s, a.y, b.y), fused(s, a.z, b.z)};
}
/// Returns b - s a.
template <class T>
V3<T> fused_less(const T& s, const V3<T>& a, const V3<T>& b) {
  return {fused_less(s, a.x, b.x), fused_less(s, a.y, b.y), fused_less(s, a.z, b.z)};
}
/// Returns v where the mask holds, and zero elsewhere.
template <class T>
V3<T> masked(const Mask<T>& mask, const V3<T>& v) {
  return {masked(mask, v.x), masked(mask, v.y), masked(mask, v.z)};
}
/// Returns |a|^2.
template <class T>
T norm2(const V3<T>& a) {
  return dot(a, a);
}
/// Returns |a|.
template <class T>
T norm(const V3<T>& a) {
  return square_root(norm2(a));
}

/// Returns a row: a vector, with a scalar in the last place.
inline Lane4 row(const Vec3& v, double scalar) { return Lane4{v.x(), v.y(), v.z(), scalar}; }
/// Returns the vector of a row, without its scalar.
inline Vec3 vector_of(const Lane4& r) { return {r[0], r[1], r[2]}; }

/// Convert between vectors of Eigen and of one contact.
inline V3<double> from_eigen(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vec3 to_eigen(const V3<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace soilweave
