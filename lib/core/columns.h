// Rows, a grain a row, become columns, a quantity a column, and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lanes.h"

namespace soilweave {

/// Columns of as many rows as T has lanes: a grain a row, a quantity a column.
template <class T>
struct Columns {
  T a, b, c, d;
};
inline Columns<Lane4> columns(const Lane4 (&r)[4]) {
  const Lane4 t0 = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
  const Lane4 t1 = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
  const Lane4 t2 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
  const Lane4 t3 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
  return {__builtin_shufflevector(t0, t2, 0, 1, 4, 5), __builtin_shufflevector(t1, t3, 0, 1, 4, 5),
          __builtin_shufflevector(t0, t2, 2, 3, 6, 7), __builtin_shufflevector(t1, t3, 2, 3, 6, 7)};
}
/// Those of rows that one of the four arguments of columns() holds; row(k) gives row k.
template <class T, class Row>
requires(width<T> == 4) T rows(const Row& row, int i) { return row(i); }
/// The rows of such columns, from the first to the last to put(i, row).
template <class Put>
void to_rows(const Lane4& a, const Lane4& b, const Lane4& c, const Lane4& d, const Put& put) {
  const Columns<Lane4> r = columns({a, b, c, d});
  put(0, r.a), put(1, r.b), put(2, r.c), put(3, r.d);
}

/// Two columns to the halves of rows; half(k) points to two numbers of row k.
template <class Half>
void to_halves(const Lane4& a, const Lane4& b, const Half& half) {
  const Lane4 t0 = __builtin_shufflevector(a, b, 0, 4, 2, 6), t1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  _mm256_storeu2_m128d(half(2), half(0), t0), _mm256_storeu2_m128d(half(3), half(1), t1);
}

}  // namespace soilweave

#ifdef SOILWEAVE_EIGHT_LANES
#include "core/columns8.h"
#endif
