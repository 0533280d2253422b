// Arithmetic shared by one contact (a double) and several at once (a GCC vector of doubles), so that a law is written
// once and gives the same bits in every lane. No branch may depend on a value: select() instead.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include "core/tensor.h"

namespace soilweave {

/// Four contacts at once: the width of the x86-64-v3 baseline. Equal bits in lane and scalar need -ffp-contract=off,
/// since the compiler may fuse a multiplication with an addition in one of them only.
using Lane4 = double __attribute__((vector_size(32)));

template <class T>
inline constexpr bool is_lane = !std::is_arithmetic_v<T>;

/// Result of comparing two values: bool for double, a vector of integers for lanes.
template <class T>
using Mask = decltype(std::declval<T>() < std::declval<T>());

template <class T>
T select(const Mask<T>& mask, const T& yes, const T& no) {
  return mask ? yes : no;
}

inline double square_root(double x) { return std::sqrt(x); }

inline Lane4 square_root(const Lane4& x) {
#ifdef __AVX__
  return __builtin_ia32_sqrtpd256(x);
#else
  return Lane4{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

/// The same number in every lane.
template <class T>
T all(double x) {
  if constexpr (is_lane<T>)
    return T{} + x;
  else
    return x;
}

template <class T>
T minimum(const T& a, const T& b) {
  return select<T>(a < b, a, b);
}
template <class T>
T maximum(const T& a, const T& b) {
  return select<T>(a > b, a, b);
}

template <class T>
T absolute(const T& x) {
  return select<T>(x < all<T>(0), -x, x);
}

template <class T>
struct V3 {
  T x, y, z;
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
V3<T> operator*(const T& s, const V3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
V3<T> select(const Mask<T>& mask, const V3<T>& yes, const V3<T>& no) {
  return {select<T>(mask, yes.x, no.x), select<T>(mask, yes.y, no.y), select<T>(mask, yes.z, no.z)};
}
template <class T>
T dot(const V3<T>& a, const V3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
V3<T> cross(const V3<T>& a, const V3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T norm2(const V3<T>& a) {
  return dot(a, a);
}
template <class T>
T norm(const V3<T>& a) {
  return square_root(norm2(a));
}

inline V3<double> from_eigen(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vec3 to_eigen(const V3<double>& v) { return {v.x, v.y, v.z}; }

/// One lane taken out, one lane put in.
inline V3<double> lane(const V3<Lane4>& v, int i) { return {v.x[i], v.y[i], v.z[i]}; }
inline void set_lane(V3<Lane4>& v, int i, const V3<double>& value) {
  v.x[i] = value.x;
  v.y[i] = value.y;
  v.z[i] = value.z;
}

}  // namespace soilweave
