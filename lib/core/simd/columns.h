// Transposes rows, one per grain, into columns, one per quantity, and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simd/lanes.h"

namespace soilweave {

/// Columns with as many rows as T has lanes: row = grain, column = quantity.
template <class T>
struct Columns {
  /// First to fourth quantity of all rows.
  T a, b, c, d;
};
/// Transposes four rows.
inline Columns<Lane4> columns(const Lane4 (&r)[4]) {
  const Lane4 t0 = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
  const Lane4 t1 = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
  const Lane4 t2 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
  const Lane4 t3 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
  return {__builtin_shufflevector(t0, t2, 0, 1, 4, 5), __builtin_shufflevector(t1, t3, 0, 1, 4, 5),
          __builtin_shufflevector(t0, t2, 2, 3, 6, 7), __builtin_shufflevector(t1, t3, 2, 3, 6, 7)};
}
/// Returns the rows that make up argument i of columns(); row(k) gives row k.
template <class T, class Row>
requires(width<T> == 4) T rows(const Row& row, int i) { return row(i); }
/// Transposes columns back to rows and passes each to put(i, row), from first to last.
template <class Put>
void to_rows(const Lane4& a, const Lane4& b, const Lane4& c, const Lane4& d, const Put& put) {
  const Columns<Lane4> r = columns({a, b, c, d});
  put(0, r.a), put(1, r.b), put(2, r.c), put(3, r.d);
}

/// Writes two columns to halves of rows; half(k) points to two numbers of row k.
template <class Half>
void to_halves(const Lane4& a, const Lane4& b, const Half& half) {
  const Lane4 t0 = __builtin_shufflevector(a, b, 0, 4, 2, 6), t1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  store_halves(half(0), half(2), t0), store_halves(half(1), half(3), t1);
}

}  // namespace soilweave

#ifdef SOILWEAVE_EIGHT_LANES
#include "core/simd/columns8.h"
#endif
