// Collects the rows of the grains of pairs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd/columns.h"
#include "dem/state/bodies.h"
#include "dem/state/space.h"

namespace soilweave::dem {

/// The grains on one side of the pairs, by byte offsets.
struct Side {
  /// First grain.
  const std::byte* grains;
  /// Byte offsets of the grains.
  const std::uint32_t* distance;
  const Grain& operator[](int k) const { return *reinterpret_cast<const Grain*>(grains + distance[k]); }
};

/// Data of pairs; differences are second grain minus first.
template <class T, class Space>
struct PairRows {
  /// Difference of positions, m, and of velocities, m/s.
  Vector<T, Space> branch, velocity;
  /// Spins, rad/s.
  Turn<T, Space> spin_1, spin_2;
  /// Radii, m.
  T radius_1, radius_2;
};

/// Reads pairs. If `folded`, adds the row shift(k) to the branch of pair k.
template <class T, bool moving, class Shift>
PairRows<T, Spatial> read_rows(const Side& one, const Side& two, bool folded, const Shift& shift, Spatial) {
  constexpr int quarter = 4;
  const auto of = [](const Side& side, Lane4 Grain::*row, int i) {
    return rows<T>([&](int k) -> const Lane4& { return side[k].*row; }, i);
  };
  T branch[quarter], velocity[quarter], spin_1[quarter], spin_2[quarter];
  for (int i = 0; i < quarter; ++i) {
    branch[i] = of(two, &Grain::position, i) - of(one, &Grain::position, i);
    velocity[i] = moving ? T(of(two, &Grain::velocity, i) - of(one, &Grain::velocity, i)) : T{};
    spin_1[i] = of(one, &Grain::spin, i), spin_2[i] = of(two, &Grain::spin, i);
  }
  if (folded)
    for (int i = 0; i < quarter; ++i) branch[i] = branch[i] + rows<T>(shift, i);
  const Columns<T> d = columns(branch), v = columns(velocity), w1 = columns(spin_1), w2 = columns(spin_2);
  return {{d.a, d.b, d.c}, {v.a, v.b, v.c}, {w1.a, w1.b, w1.c}, {w2.a, w2.b, w2.c}, w1.d, w2.d};
}

/// Reads pairs of disks. Positions are read first, so that square roots begin while velocities are read.
template <class T, bool moving, class Shift>
PairRows<T, Planar> read_rows(const Side& one, const Side& two, bool folded, const Shift& shift, Planar) {
  constexpr int quarter = 4;
  const auto columns_of = [](const Side& side, Lane4 Grain::*row) {
    T piece[quarter];
    for (int i = 0; i < quarter; ++i) piece[i] = rows<T>([&](int k) -> const Lane4& { return side[k].*row; }, i);
    return columns(piece);
  };
  const Columns<T> x1 = columns_of(one, &Grain::position), x2 = columns_of(two, &Grain::position);
  V2<T> branch{x2.a - x1.a, x2.b - x1.b};
  if (folded) {
    const Columns<T> s = columns({rows<T>(shift, 0), rows<T>(shift, 1), rows<T>(shift, 2), rows<T>(shift, 3)});
    branch = branch + V2<T>{s.a, s.b};
  }
  if constexpr (!moving) return {branch, {T{}, T{}}, T{}, T{}, x1.d, x2.d};
  const Columns<T> v1 = columns_of(one, &Grain::velocity), v2 = columns_of(two, &Grain::velocity);
  return {branch, {v2.a - v1.a, v2.b - v1.b}, v1.c, v2.c, x1.d, x2.d};
}

}  // namespace soilweave::dem
