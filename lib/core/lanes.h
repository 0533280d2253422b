// Arithmetic shared by one contact (a double) and several at once (a GCC vector of doubles), so that a law is written
// once and gives the same bits in every lane. No branch may depend on a value: select() instead.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <type_traits>

namespace soilweave {

/// Four contacts at once: the width of the x86-64-v3 baseline.
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

template <class T>
T square_root(const T& x) {
  if constexpr (is_lane<T>) {
    T y = x;
    for (std::size_t k = 0; k < sizeof(T) / sizeof(double); ++k) y[k] = std::sqrt(x[k]);
    return y;
  } else {
    return std::sqrt(x);
  }
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

}  // namespace soilweave
