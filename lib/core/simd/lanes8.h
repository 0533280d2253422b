// Eight contacts at once, with AVX-512 or, for tests, without. Only lanes.h includes this file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave {

/// Eight contacts at once.
using Lane8 = double __attribute__((vector_size(64)));

/// Returns the lower four lanes; high() the upper four; join() makes eight of them.
inline Lane4 low(const Lane8& x) { return __builtin_shufflevector(x, x, 0, 1, 2, 3); }

#if defined(__AVX512F__) && !defined(SOILWEAVE_PORTABLE)
inline Lane4 high(const Lane8& x) { return _mm512_extractf64x4_pd(x, 1); }
// The intrinsic takes one instruction; GCC makes three from a shuffle.
inline Lane8 join(const Lane4& a, const Lane4& b) { return _mm512_insertf64x4(_mm512_castpd256_pd512(a), b, 1); }
inline Lane8 square_root(const Lane8& x) { return _mm512_sqrt_pd(x); }
inline Lane8 fused(const Lane8& a, const Lane8& b, const Lane8& c) { return _mm512_fmadd_pd(a, b, c); }
inline Lane8 fused_less(const Lane8& a, const Lane8& b, const Lane8& c) { return _mm512_fnmadd_pd(a, b, c); }
inline unsigned bits(const Mask<Lane8>& mask) {
  __m512i integers;
  std::memcpy(&integers, &mask, sizeof integers);
  return _mm512_cmplt_epi64_mask(integers, _mm512_setzero_si512());
}
#else
inline Lane4 high(const Lane8& x) { return __builtin_shufflevector(x, x, 4, 5, 6, 7); }
inline Lane8 join(const Lane4& a, const Lane4& b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); }
inline Lane8 square_root(const Lane8& x) { return join(square_root(low(x)), square_root(high(x))); }
inline Lane8 fused(const Lane8& a, const Lane8& b, const Lane8& c) {
  return join(fused(low(a), low(b), low(c)), fused(high(a), high(b), high(c)));
}
inline Lane8 fused_less(const Lane8& a, const Lane8& b, const Lane8& c) {
  return join(fused_less(low(a), low(b), low(c)), fused_less(high(a), high(b), high(c)));
}
inline unsigned bits(const Mask<Lane8>& mask) {
  return bits(__builtin_shufflevector(mask, mask, 0, 1, 2, 3)) |
         (bits(__builtin_shufflevector(mask, mask, 4, 5, 6, 7)) << 4);
}
#endif

}  // namespace soilweave
