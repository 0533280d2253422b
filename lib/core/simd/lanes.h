// Arithmetic on one contact (a double) or several at once (a GCC vector of doubles), with the same bits in every lane.
// No branch may depend on a value: select() replaces it. Only fused() joins a multiplication and an addition.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace soilweave {

/// Four contacts at once, the width of x86-64-v3. Equal bits of lanes and scalars need -ffp-contract=off.
using Lane4 = double __attribute__((vector_size(32)));

/// Whether T holds several contacts.
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

/// Returns a b + c, rounded once, for lanes and scalars alike.
inline double fused(double a, double b, double c) { return std::fma(a, b, c); }
/// Returns c - a b, rounded once.
inline double fused_less(double a, double b, double c) { return std::fma(-a, b, c); }

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

}  // namespace soilweave

// Four lanes: square_root(), fused(), fused_less(), store_halves(), and bits(), an integer whose bit i is lane i of a
// mask.
#include "core/simd/lanes_portable.h"
#if defined(__x86_64__) && !defined(SOILWEAVE_PORTABLE)
#include "core/simd/lanes_x86.h"
#else
namespace soilweave {
using portable::bits;
using portable::fused;
using portable::fused_less;
using portable::square_root;
using portable::store_halves;
}  // namespace soilweave
#endif
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
