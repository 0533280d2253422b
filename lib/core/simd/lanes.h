// Arithmetic on one contact (a double) or several at once (a GCC vector of doubles). A law is written once and gives
// the same bits in every lane. No branch may depend on a value: select() replaces it. Only fused() makes one operation
// of a multiplication and an addition.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <immintrin.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace soilweave {

/// Four contacts at once, the width of x86-64-v3. Lanes and scalars need -ffp-contract=off for equal bits, since the
/// compiler may otherwise fuse a multiplication with an addition in only one of them.
using Lane4 = double __attribute__((vector_size(32)));

template <class T>
inline constexpr bool is_lane = !std::is_arithmetic_v<T>;

/// Result of a comparison: bool for double, a vector of integers for lanes.
template <class T>
using Mask = decltype(std::declval<T>() < std::declval<T>());

/// Returns `yes` in lanes where the mask holds, `no` elsewhere. Both are computed.
template <class T>
T select(const Mask<T>& mask, const T& yes, const T& no) {
  return mask ? yes : no;
}

/// Returns the square root, correctly rounded, for lanes and scalars alike.
inline double square_root(double x) { return std::sqrt(x); }

inline Lane4 square_root(const Lane4& x) { return _mm256_sqrt_pd(x); }

/// Returns a b + c, rounded once, for lanes and scalars alike.
inline double fused(double a, double b, double c) { return std::fma(a, b, c); }
inline Lane4 fused(const Lane4& a, const Lane4& b, const Lane4& c) { return _mm256_fmadd_pd(a, b, c); }
/// Returns c - a b, rounded once.
inline double fused_less(double a, double b, double c) { return std::fma(-a, b, c); }
inline Lane4 fused_less(const Lane4& a, const Lane4& b, const Lane4& c) { return _mm256_fnmadd_pd(a, b, c); }

/// Returns a register with one number in every lane.
template <class T>
T broadcast(double x) {
  if constexpr (is_lane<T>)
    return x - T{};
  else
    return x;
}

/// Number of contacts that a T holds.
template <class T>
inline constexpr int width = static_cast<int>(sizeof(T) / sizeof(double));

/// Load and store consecutive doubles of any alignment.
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

/// Returns an integer whose bit i is lane i of the mask.
inline unsigned bits(const Mask<Lane4>& mask) {
  Lane4 signs;
  std::memcpy(&signs, &mask, sizeof signs);
  return static_cast<unsigned>(_mm256_movemask_pd(signs));
}

}  // namespace soilweave

#ifdef SOILWEAVE_EIGHT_LANES
#include "core/simd/lanes8.h"
#endif

namespace soilweave {

/// Widest register that this object is compiled for.
#ifdef SOILWEAVE_EIGHT_LANES
using Lanes = Lane8;
#else
using Lanes = Lane4;
#endif

/// Returns whether the mask holds in any lane.
inline bool any(bool mask) { return mask; }
template <class M>
bool any(const M& mask) {
  return bits(mask) != 0;
}

/// Returns x where the mask holds and +0 elsewhere, even if x is a NaN.
inline double masked(bool mask, double x) { return mask ? x : 0.0; }
template <class T>
requires is_lane<T> T masked(const Mask<T>& mask, const T& x) {
  Mask<T> raw;
  std::memcpy(&raw, &x, sizeof raw);
  raw &= mask;
  T kept;
  std::memcpy(&kept, &raw, sizeof kept);
  return kept;
}

/// Return the smaller or larger of two numbers by lane. If one is a NaN, the second argument is returned.
template <class T>
T minimum(const T& a, const T& b) {
  return select<T>(a < b, a, b);
}
template <class T>
T maximum(const T& a, const T& b) {
  return select<T>(a > b, a, b);
}

/// Returns the magnitude of each lane.
template <class T>
T absolute(const T& x) {
  return select<T>(x < broadcast<T>(0), -x, x);
}

}  // namespace soilweave
