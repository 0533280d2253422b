// Columns of eight rows (columns.h has those of four). Only columns.h includes this file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave {

/// Transposes eight rows: r[i] holds row i and row i + 4.
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
/// Returns rows i and i + 4 in one register.
template <class T, class Row>
requires(width<T> == 8) T rows(const Row& row, int i) { return join(row(i), row(i + 4)); }
/// Transposes columns back to eight rows and passes each to put(i, row).
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
/// Writes two columns to halves of eight rows.
template <class Half>
void to_halves(const Lane8& a, const Lane8& b, const Half& half) {
  const Lane8 even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lane8 odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  store_halves(half(0), half(2), low(even)), store_halves(half(1), half(3), low(odd));
  store_halves(half(4), half(6), high(even)), store_halves(half(5), half(7), high(odd));
}

}  // namespace soilweave
