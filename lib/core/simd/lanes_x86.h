// Vector instructions of x86-64-v3 for four lanes. Only lanes.h includes this file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <immintrin.h>

#include <cstring>

namespace soilweave {

inline Lane4 square_root(const Lane4& x) { return _mm256_sqrt_pd(x); }
inline Lane4 fused(const Lane4& a, const Lane4& b, const Lane4& c) { return _mm256_fmadd_pd(a, b, c); }
inline Lane4 fused_less(const Lane4& a, const Lane4& b, const Lane4& c) { return _mm256_fnmadd_pd(a, b, c); }

/// Returns an integer whose bit i is lane i of the mask.
inline unsigned bits(const Mask<Lane4>& mask) {
  Lane4 signs;
  std::memcpy(&signs, &mask, sizeof signs);
  return static_cast<unsigned>(_mm256_movemask_pd(signs));
}

/// Stores the lower two lanes and the upper two, each as two consecutive doubles.
inline void store_halves(double* lower, double* upper, const Lane4& x) { _mm256_storeu2_m128d(upper, lower, x); }

}  // namespace soilweave
