// Four lanes of a block of pairs: how the sweep reads and writes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <vector>

#include "dem/bodies.h"
#include "dem/contacts.h"
#include "dem/pair_geometry.h"

namespace soilweave::dem {

/// The lanes from k on.
struct BlockLanes {
  ContactBlock* block;
  int k;

  unsigned touching() const { return (block->touching >> k) & 15u; }
  void set_masks(unsigned touching, unsigned sliding) const {
    block->touching = (block->touching & ~(15u << k)) | (touching << k);
    block->sliding = (block->sliding & ~(15u << k)) | (sliding << k);
  }

  V3<Lane4> load3(const double (&from)[3][ContactBlock::size]) const {
    return {load<Lane4>(from[0] + k), load<Lane4>(from[1] + k), load<Lane4>(from[2] + k)};
  }
  void store3(double (&to)[3][ContactBlock::size], const V3<Lane4>& v) const {
    store(to[0] + k, v.x), store(to[1] + k, v.y), store(to[2] + k, v.z);
  }
  Memory<Lane4> memory() const {
    return {load3(block->shear), load3(block->rolling), load<Lane4>(block->twisting + k)};
  }

  /// Both grains of each pair.
  Meeting<Lane4> meeting(const Bodies& bodies, const Mat3& cell) const {
    Meeting<Lane4> m;
    const std::int32_t *i = block->first + k, *j = block->second + k;
    // Differences of rows first: one transposition instead of two, and the radius and mass of the first grain back from
    // ones of their own.
    const Rows4 x1 = rows(bodies.position, i), x2 = rows(bodies.position, j);
    const Rows4 d = transpose({x2.a - x1.a, x2.b - x1.b, x2.c - x1.c, x2.d - x1.d});
    m.branch = {d.a, d.b, d.c};
    if (block->folded) m.branch = m.branch + shift(cell);
    m.r1 = last(x1), m.r2 = last(x2);
    const Rows4 v1 = rows(bodies.velocity, i), v2 = rows(bodies.velocity, j);
    const Rows4 v = transpose({v2.a - v1.a, v2.b - v1.b, v2.c - v1.c, v2.d - v1.d});
    m.velocity = {v.a, v.b, v.c};
    m.m1 = last(v1), m.m2 = last(v2);
    const Rows4 w1 = transpose(rows(bodies.spin, i)), w2 = transpose(rows(bodies.spin, j));
    m.spin_1 = {w1.a, w1.b, w1.c}, m.spin_2 = {w2.a, w2.b, w2.c};
    return m;
  }

  /// A row a pair, of a vector each, to its slot.
  void write(const std::uint32_t* slot, const V3<Lane4>& force, const V3<Lane4>& torque, std::vector<Slot>& to) const {
    const Rows4 f = transpose({force.x, force.y, force.z, Lane4{}}),
                t = transpose({torque.x, torque.y, torque.z, Lane4{}});
    Slot* slots = to.data();
    slots[slot[k]] = {f.a, t.a};
    slots[slot[k + 1]] = {f.b, t.b};
    slots[slot[k + 2]] = {f.c, t.c};
    slots[slot[k + 3]] = {f.d, t.d};
  }

 private:
  Lane4 column(const std::int32_t* from) const {
    __m128i integers;
    std::memcpy(&integers, from + k, sizeof integers);
    return _mm256_cvtepi32_pd(integers);
  }
  V3<Lane4> shift(const Mat3& h) const {
    const Lane4 a = column(block->image[0]), b = column(block->image[1]), c = column(block->image[2]);
    const auto component = [&](int i) {
      return fused(all<Lane4>(h(i, 2)), c, fused(all<Lane4>(h(i, 1)), b, h(i, 0) * a));
    };
    return {component(0), component(1), component(2)};
  }
  static Rows4 rows(const std::vector<Lane4>& of, const std::int32_t* index) {
    const Lane4* p = of.data();
    return {p[index[0]], p[index[1]], p[index[2]], p[index[3]]};
  }
  // The last column of four rows.
  static Lane4 last(const Rows4& r) {
    const Lane4 ab = __builtin_shufflevector(r.a, r.b, 1, 5, 3, 7), cd = __builtin_shufflevector(r.c, r.d, 1, 5, 3, 7);
    return __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
  }
};

}  // namespace soilweave::dem
