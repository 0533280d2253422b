// Sums over contacts, to equal bits for any width of the register.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simd/columns.h"
#include "core/simd/v2.h"
#include "core/simd/v3.h"

namespace soilweave::dem {

/// Adds four quantities of every contact to a row, contact by contact.
template <class T>
void add_to(Lane4& row, const T& a, const T& b, const T& c, const T& d) {
  if constexpr (is_lane<T>)
    to_rows(a, b, c, d, [&row](int, const Lane4& contact) { row = row + contact; });
  else
    row = row + Lane4{a, b, c, d};
}

/// Adds a vector of every contact to a row.
template <class T>
void add_to(Lane4& row, const V3<T>& v) {
  add_to(row, v.x, v.y, v.z, T{});
}
template <class T>
void add_to(Lane4& row, const V2<T>& v) {
  add_to(row, v.x, v.y, T{}, T{});
}

}  // namespace soilweave::dem
