// What the grains of pairs tell, from their rows. A pair after the other, all that is needed of its grains at once:
// else more addresses are alive than the processor has registers for. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/columns.h"
#include "dem/bodies.h"
#include "dem/space.h"

namespace soilweave::dem {

/// The grains at one side of the pairs; distances in bytes.
struct Side {
  const std::byte* grains;
  const std::uint32_t* distance;
  const Grain& operator[](int k) const { return *reinterpret_cast<const Grain*>(grains + distance[k]); }
};

/// Second grain less first, in branch and velocity.
template <class T, class Space>
struct PairRows {
  Vector<T, Space> branch, velocity;
  Turn<T, Space> spin_1, spin_2;
  T radius_1, radius_2;
};

/// Where pairs reach across the cell's faces, its offset comes with the branch: shift(k) is a row.
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

template <class T, bool moving, class Shift>
PairRows<T, Planar> read_rows(const Side& one, const Side& two, bool folded, const Shift& shift, Planar) {
  constexpr int pieces = width<T> / 2;
  const auto of = [](const Side& side, Lane4 Grain::*row, int from, int piece) {
    return halves<T>([&](int k) { return reinterpret_cast<const double*>(&(side[k].*row)) + from; }, piece);
  };
  Lane4 branch[pieces], velocity[pieces], spin_1[pieces], spin_2[pieces];
  for (int i = 0; i < pieces; ++i) {
    branch[i] = of(two, &Grain::position, 0, i) - of(one, &Grain::position, 0, i);
    velocity[i] = moving ? Lane4(of(two, &Grain::velocity, 0, i) - of(one, &Grain::velocity, 0, i)) : Lane4{};
    spin_1[i] = of(one, &Grain::spin, 2, i), spin_2[i] = of(two, &Grain::spin, 2, i);
  }
  if (folded)
    for (int i = 0; i < pieces; ++i)
      branch[i] += halves<T>([&](int k) { return reinterpret_cast<const double*>(&shift(k)); }, i);
  const Halves<T> d = columns_of_halves<T>(branch), v = columns_of_halves<T>(velocity);
  const Halves<T> w1 = columns_of_halves<T>(spin_1), w2 = columns_of_halves<T>(spin_2);
  return {{d.a, d.b}, {v.a, v.b}, w1.a, w2.a, w1.b, w2.b};
}

}  // namespace soilweave::dem
