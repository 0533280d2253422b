// Loops over lanes for processors other than x86-64. Only lanes.h includes this file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

/// Functions of lanes_x86.h as loops, with the same bits; a test compares them.
namespace soilweave::portable {

/// Returns the lanes of a register as numbers.
/// GCC 12's bounds sanitizer reads a wrong index from a register reached through a reference.
inline std::array<double, 4> apart(const Lane4& x) { return std::bit_cast<std::array<double, 4>>(x); }

/// Returns the register whose lane i is of(i).
template <class Of>
Lane4 by_lane(const Of& of) {
  return Lane4{of(0), of(1), of(2), of(3)};
}

inline Lane4 square_root(const Lane4& x) {
  const auto lanes = apart(x);
  return by_lane([&](std::size_t i) { return std::sqrt(lanes[i]); });
}

inline Lane4 fused(const Lane4& a, const Lane4& b, const Lane4& c) {
  const auto p = apart(a), q = apart(b), r = apart(c);
  return by_lane([&](std::size_t i) { return std::fma(p[i], q[i], r[i]); });
}

inline Lane4 fused_less(const Lane4& a, const Lane4& b, const Lane4& c) {
  const auto p = apart(a), q = apart(b), r = apart(c);
  return by_lane([&](std::size_t i) { return std::fma(-p[i], q[i], r[i]); });
}

/// Returns an integer whose bit i is lane i of the mask.
inline unsigned bits(const Mask<Lane4>& mask) {
  const auto lanes = std::bit_cast<std::array<std::int64_t, 4>>(mask);
  unsigned set = 0;
  for (std::size_t i = 0; i < 4; ++i) set |= (lanes[i] < 0 ? 1U : 0U) << i;
  return set;
}

/// Stores the lower two lanes and the upper two, each as two consecutive doubles.
inline void store_halves(double* lower, double* upper, const Lane4& x) {
  const auto lanes = apart(x);
  for (std::size_t i = 0; i < 2; ++i) lower[i] = lanes[i], upper[i] = lanes[i + 2];
}

}  // namespace soilweave::portable
