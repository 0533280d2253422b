// Eight contacts at once: what lanes.h says of four, for the object that is compiled for AVX-512 (and, for tests of its
// bits, for the baseline). Included by lanes.h alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave {

using Lane8 = double __attribute__((vector_size(64)));

inline Lane4 low(const Lane8& x) { return __builtin_shufflevector(x, x, 0, 1, 2, 3); }
inline Lane4 high(const Lane8& x) { return __builtin_shufflevector(x, x, 4, 5, 6, 7); }
inline Lane8 join(const Lane4& a, const Lane4& b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); }

#ifdef __AVX512F__
inline Lane8 square_root(const Lane8& x) { return _mm512_sqrt_pd(x); }
inline Lane8 fused(const Lane8& a, const Lane8& b, const Lane8& c) { return _mm512_fmadd_pd(a, b, c); }
inline Lane8 fused_less(const Lane8& a, const Lane8& b, const Lane8& c) { return _mm512_fnmadd_pd(a, b, c); }
inline unsigned bits(const Mask<Lane8>& mask) {
  __m512i integers;
  std::memcpy(&integers, &mask, sizeof integers);
  return _mm512_cmplt_epi64_mask(integers, _mm512_setzero_si512());
}
#else
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

/// r[i] holds row i and row i + 4.
inline Columns<Lane8> columns(const Lane8 (&r)[4]) {
  const Lane8 t0 = __builtin_shufflevector(r[0], r[1], 0, 8, 2, 10, 4, 12, 6, 14);
  const Lane8 t1 = __builtin_shufflevector(r[0], r[1], 1, 9, 3, 11, 5, 13, 7, 15);
  const Lane8 t2 = __builtin_shufflevector(r[2], r[3], 0, 8, 2, 10, 4, 12, 6, 14);
  const Lane8 t3 = __builtin_shufflevector(r[2], r[3], 1, 9, 3, 11, 5, 13, 7, 15);
  return {__builtin_shufflevector(t0, t2, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(t0, t2, 2, 3, 10, 11, 6, 7, 14, 15),
          __builtin_shufflevector(t1, t3, 2, 3, 10, 11, 6, 7, 14, 15)};
}
template <class T, class Row>
requires(width<T> == 8) T rows(const Row& row, int i) { return join(row(i), row(i + 4)); }
template <class Put>
void to_rows(const Lane8& a, const Lane8& b, const Lane8& c, const Lane8& d, const Put& put) {
  const Lane8 t0 = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lane8 t1 = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lane8 t2 = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lane8 t3 = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lane8 r02 = __builtin_shufflevector(t0, t2, 0, 1, 8, 9, 2, 3, 10, 11);
  const Lane8 r13 = __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 2, 3, 10, 11);
  const Lane8 r46 = __builtin_shufflevector(t0, t2, 4, 5, 12, 13, 6, 7, 14, 15);
  const Lane8 r57 = __builtin_shufflevector(t1, t3, 4, 5, 12, 13, 6, 7, 14, 15);
  put(0, low(r02)), put(1, low(r13)), put(2, high(r02)), put(3, high(r13));
  put(4, low(r46)), put(5, low(r57)), put(6, high(r46)), put(7, high(r57));
}
template <class T, class Half>
requires(width<T> == 8) Lane4 halves(const Half& half, int piece) {
  const int k = 4 * (piece % 2) + piece / 2;  // 0 and 2, 4 and 6, 1 and 3, 5 and 7
  return pair_of(half(k), half(k + 2));
}
template <class T>
requires(width<T> == 8) Halves<T> columns_of_halves(const Lane4 (&piece)[4]) {
  const Lane8 even = join(piece[0], piece[1]), odd = join(piece[2], piece[3]);
  return {__builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14),
          __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15)};
}

template <class Half>
void to_halves(const Lane8& a, const Lane8& b, const Half& half) {
  const Lane8 even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lane8 odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  _mm256_storeu2_m128d(half(2), half(0), low(even)), _mm256_storeu2_m128d(half(3), half(1), low(odd));
  _mm256_storeu2_m128d(half(6), half(4), high(even)), _mm256_storeu2_m128d(half(7), half(5), high(odd));
}

}  // namespace soilweave
