// Loops over lanes in place of the vector instructions of x86-64, for other processors. Only lanes.h includes it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

/// Functions of lanes_x86.h as loops, with the same bits; a test compares them.
namespace soilweave::portable {

/// Returns the register whose lane i is of(i).
template <class Of>
Lane4 by_lane(const Of& of) {
  return Lane4{of(0), of(1), of(2), of(3)};
}

inline Lane4 square_root(const Lane4& x) {
  return by_lane([&](int i) { return std::sqrt(x[i]); });
}

inline Lane4 fused(const Lane4& a, const Lane4& b, const Lane4& c) {
  return by_lane([&](int i) { return std::fma(a[i], b[i], c[i]); });
}

inline Lane4 fused_less(const Lane4& a, const Lane4& b, const Lane4& c) {
  return by_lane([&](int i) { return std::fma(-a[i], b[i], c[i]); });
}

inline unsigned bits(const Mask<Lane4>& mask) {
  unsigned set = 0;
  for (int i = 0; i < 4; ++i) set |= (mask[i] < 0 ? 1U : 0U) << i;
  return set;
}

inline void store_halves(double* lower, double* upper, const Lane4& x) {
  for (int i = 0; i < 2; ++i) lower[i] = x[i], upper[i] = x[i + 2];
}

}  // namespace soilweave::portable
