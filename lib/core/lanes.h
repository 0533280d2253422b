// Arithmetic shared by one contact (a double) and several at once (a GCC vector of doubles), so that a law is written
// once and gives the same bits in every lane. No branch may depend on a value: select() instead.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
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

/// How many contacts a T holds.
template <class T>
inline constexpr int width = static_cast<int>(sizeof(T) / sizeof(double));

/// From and to consecutive doubles, whatever their alignment.
template <class T>
T load(const double* from) {
  T x;
  std::memcpy(&x, from, sizeof(T));
  return x;
}
template <class T>
void store(double* to, const T& x) {
  std::memcpy(to, &x, sizeof(T));
}

/// Bit i of the result is lane i of the mask.
inline unsigned bits(const Mask<Lane4>& mask) {
  unsigned all_bits = 0;
  for (int i = 0; i < 4; ++i) all_bits |= static_cast<unsigned>(mask[i] & 1) << i;
  return all_bits;
}

/// x where the mask holds, +0 elsewhere, even where x is not a number.
inline Lane4 keep(const Mask<Lane4>& mask, const Lane4& x) {
  Mask<Lane4> raw;
  std::memcpy(&raw, &x, sizeof raw);
  raw &= mask;
  Lane4 kept;
  std::memcpy(&kept, &raw, sizeof kept);
  return kept;
}

/// Four rows of four become four columns: a grain a row, a quantity a column, and back.
struct Rows4 {
  Lane4 a, b, c, d;
};
inline Rows4 transpose(const Rows4& r) {
  const Lane4 t0 = __builtin_shuffle(r.a, r.b, Mask<Lane4>{0, 4, 2, 6});
  const Lane4 t1 = __builtin_shuffle(r.a, r.b, Mask<Lane4>{1, 5, 3, 7});
  const Lane4 t2 = __builtin_shuffle(r.c, r.d, Mask<Lane4>{0, 4, 2, 6});
  const Lane4 t3 = __builtin_shuffle(r.c, r.d, Mask<Lane4>{1, 5, 3, 7});
  return {__builtin_shuffle(t0, t2, Mask<Lane4>{0, 1, 4, 5}), __builtin_shuffle(t1, t3, Mask<Lane4>{0, 1, 4, 5}),
          __builtin_shuffle(t0, t2, Mask<Lane4>{2, 3, 6, 7}), __builtin_shuffle(t1, t3, Mask<Lane4>{2, 3, 6, 7})};
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

/// A row holds a vector and, in its last place, a scalar that goes with it.
inline Lane4 row(const Vec3& v, double scalar) { return Lane4{v.x(), v.y(), v.z(), scalar}; }
inline Vec3 vector_of(const Lane4& r) { return {r[0], r[1], r[2]}; }

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
