// The lanes of a block of pairs that one register holds: how the sweep reads and writes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/bodies.h"
#include "dem/contacts.h"
#include "dem/pair_geometry.h"

namespace soilweave::dem {

/// The row at a distance, counted in numbers, from the first.
inline Lane4 row_at(const std::vector<Lane4>& rows, std::size_t distance) {
  return load<Lane4>(reinterpret_cast<const double*>(rows.data()) + distance);
}

/// The lanes from k on.
template <class T>
struct BlockLanes {
  ContactBlock* block;
  double* reals;              // lane k of the first of the block's arrays of them
  const std::uint32_t* rows;  // and of the first of its distances

  BlockLanes() = default;
  BlockLanes(ContactBlock* b, int k) : block(b), reals(b->normal[0] + k), rows(b->first + k) {}

  static constexpr unsigned full = (1u << width<T>)-1;
  int lane() const { return static_cast<int>(rows - block->first); }
  unsigned touching() const { return (block->touching >> lane()) & full; }
  void set_masks(unsigned touching, unsigned sliding) const {
    const int k = lane();
    const unsigned others = ~(full << k);
    block->touching = (block->touching & others) | (touching << k);
    block->sliding = (block->sliding & others) | (sliding << k);
  }
  std::size_t first(int lane) const { return rows[lane]; }
  std::size_t second(int lane) const { return rows[ContactBlock::size + lane]; }
  std::size_t image(int lane) const { return rows[2 * ContactBlock::size + lane]; }
  std::size_t load_second(int lane) const { return rows[3 * ContactBlock::size + lane]; }

  V3<T> normal() const { return load3(0); }
  Memory<T> memory() const { return {load3(3), load3(6), load<T>(reals + 9 * ContactBlock::size)}; }
  void remember(const V3<T>& normal, const Memory<T>& memory, const T& normal_force) const {
    store3(0, normal), store3(3, memory.shear), store3(6, memory.rolling);
    store(reals + 9 * ContactBlock::size, memory.twisting), store(reals + 10 * ContactBlock::size, normal_force);
  }

  /// Second grain less first; a cell offset comes with `shifts`, a row for each of Contacts::images.
  V3<T> branch(const Bodies& bodies, const std::vector<Lane4>& shifts) const {
    const auto& x = bodies.position;
    const auto between = [&](int lane) { return row_at(x, second(lane)) - row_at(x, first(lane)); };
    const Columns<T> d = block->folded
                             ? columns<T>([&](int lane) { return between(lane) + row_at(shifts, image(lane)); })
                             : columns<T>(between);
    return {d.a, d.b, d.c};
  }
  V3<T> velocity(const Bodies& bodies) const {
    const auto& v = bodies.velocity;
    const Columns<T> d = columns<T>([&](int lane) { return row_at(v, second(lane)) - row_at(v, first(lane)); });
    return {d.a, d.b, d.c};
  }
  void spins_and_radii(const Bodies& bodies, PairMotion<T>& motion) const {
    const Columns<T> one = columns<T>([&](int lane) { return row_at(bodies.spin, first(lane)); });
    motion.spin_1 = {one.a, one.b, one.c}, motion.lever_1 = one.d;
    const Columns<T> two = columns<T>([&](int lane) { return row_at(bodies.spin, second(lane)); });
    motion.spin_2 = {two.a, two.b, two.c}, motion.lever_2 = two.d;
  }
  void masses(const Bodies& bodies, Kinematics<T>& kinematics) const {
    double one[width<T>], two[width<T>];
    for (int lane = 0; lane < width<T>; ++lane)
      one[lane] = row_at(bodies.velocity, first(lane))[3], two[lane] = row_at(bodies.velocity, second(lane))[3];
    kinematics.m1 = load<T>(one), kinematics.m2 = load<T>(two);
  }

 private:
  V3<T> load3(int array) const {
    const double* from = reals + array * ContactBlock::size;
    return {load<T>(from), load<T>(from + ContactBlock::size), load<T>(from + 2 * ContactBlock::size)};
  }
  void store3(int array, const V3<T>& v) const {
    double* to = reals + array * ContactBlock::size;
    store(to, v.x), store(to + ContactBlock::size, v.y), store(to + 2 * ContactBlock::size, v.z);
  }
};

/// Calls memory for what the sweep will come to: blocks, and the grains of other chunks that one of them names.
inline void call_for(const ContactBlock* next, const ContactBlock* end, const Bodies& bodies, const double* loads) {
  constexpr int ahead = 6, soon = 3, line = 64;
  if (end - next <= ahead) return;
  const char* block = reinterpret_cast<const char*>(next + ahead);
  for (std::size_t at = 0; at < sizeof(ContactBlock); at += line) __builtin_prefetch(block + at);
  if (!next[soon].far) return;
  for (int lane = 0; lane < ContactBlock::size; ++lane) {
    const std::uint32_t second = next[soon].second[lane];
    for (const auto* rows : {&bodies.position, &bodies.velocity, &bodies.spin})
      __builtin_prefetch(reinterpret_cast<const double*>(rows->data()) + second);
    __builtin_prefetch(loads + 2 * static_cast<std::size_t>(next[soon].load_second[lane]));
  }
}

}  // namespace soilweave::dem
