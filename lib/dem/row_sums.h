// Sums over contacts that are the same whether contacts come one by one or four at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lanes.h"

namespace soilweave::dem {

/// Sums of n rows of four quantities each. Four contacts become four rows by transposition, added one after the other.
template <int n>
struct RowSums {
  Lane4 row[n] = {};

  void add(int r, const Rows4& quantities) {
    const Rows4 contact = transpose(quantities);
    row[r] = row[r] + contact.a + contact.b + contact.c + contact.d;
  }
  void add(int r, double a, double b, double c, double d) { row[r] += Lane4{a, b, c, d}; }
  void add(int r, const Lane4& a, const Lane4& b, const Lane4& c, const Lane4& d) { add(r, Rows4{a, b, c, d}); }
};

}  // namespace soilweave::dem
