// The lanes of a block of pairs that one register holds: how the sweep reads and writes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/bodies.h"
#include "dem/contacts.h"
#include "dem/pair_geometry.h"

namespace soilweave::dem {

/// The lanes from k on.
template <class T>
struct BlockLanes {
  ContactBlock* block;
  int lane;

  static constexpr unsigned full = (1u << width<T>)-1;
  unsigned touching() const { return (unsigned{block->touching} >> lane) & full; }
  void set_masks(unsigned touching, unsigned sliding) const {
    const unsigned others = ~(full << lane);
    block->touching = static_cast<std::uint8_t>((block->touching & others) | (touching << lane));
    block->sliding = static_cast<std::uint8_t>((block->sliding & others) | (sliding << lane));
  }
  std::size_t first(int k) const { return block->first[lane + k]; }
  std::size_t second(int k) const { return block->second[lane + k]; }
  std::size_t load_first(int k) const { return first(k) / (ContactBlock::grain_size / ContactBlock::load_size); }
  std::size_t load_second(int k) const { return block->load_second[lane + k]; }
  std::size_t image(int k) const { return block->image[lane + k]; }

  template <class Space>
  Vector<T, Space> shear() const {
    return vector(block->shear, Vector<T, Space>());
  }
  template <class Space>
  Turn<T, Space> rolling() const {
    return turn(block->rolling, Turn<T, Space>());
  }
  T twisting() const { return load<T>(block->twisting + lane); }
  T normal_force() const { return load<T>(block->normal_force + lane); }
  template <class V>
  void remember_shear(const V& shear) const {
    put(shear, block->shear);
  }
  template <class Space>
  void remember_moments(const Memory<T, Space>& memory) const {
    put(memory.rolling, block->rolling);
    if constexpr (Space::twists) store(block->twisting + lane, memory.twisting);
  }
  void forget_moments() const { remember_moments(Memory<T, Spatial>{}); }
  void remember_normal_force(const T& force) const { store(block->normal_force + lane, force); }

  /// The grains of the pairs.
  struct Ends {
    const Grain *first[width<T>], *second[width<T>];
  };
  Ends ends(const double* grains) const {
    const auto at = [grains](std::size_t distance) { return reinterpret_cast<const Grain*>(grains + distance); };
    Ends ends;
    for (int k = 0; k < width<T>; ++k) ends.first[k] = at(first(k)), ends.second[k] = at(second(k));
    return ends;
  }
  /// Second grain less first; a cell offset comes with `shifts`, a row for each of Contacts::images.
  template <class Space>
  Vector<T, Space> branch(const Ends& ends, const std::vector<Lane4>& shifts) const {
    const auto between = [&](int k) { return ends.second[k]->position - ends.first[k]->position; };
    return Space::vector(block->folded ? columns<T>([&](int k) { return between(k) + shifts[image(k)]; })
                                       : columns<T>(between));
  }
  template <class Space>
  static Vector<T, Space> velocity(const Ends& ends) {
    return Space::vector(columns<T>([&](int k) { return ends.second[k]->velocity - ends.first[k]->velocity; }));
  }
  template <class Space>
  static void spins_and_radii(const Ends& ends, PairMotion<T, Space>& motion) {
    const Columns<T> one = columns<T>([&](int k) { return ends.first[k]->spin; });
    motion.spin_1 = Space::turn(one), motion.lever_1 = one.d;
    const Columns<T> two = columns<T>([&](int k) { return ends.second[k]->spin; });
    motion.spin_2 = Space::turn(two), motion.lever_2 = two.d;
  }
  template <class Space>
  static void masses(const Ends& ends, Kinematics<T, Space>& kinematics) {
    double one[width<T>], two[width<T>];
    for (int k = 0; k < width<T>; ++k) one[k] = ends.first[k]->velocity[3], two[k] = ends.second[k]->velocity[3];
    kinematics.m1 = load<T>(one), kinematics.m2 = load<T>(two);
  }

 private:
  using Array = double[ContactBlock::size];

  // The last argument tells the kind. A turn in the plane is the third part.
  V3<T> vector(const Array (&from)[3], const V3<T>&) const {
    return {load<T>(from[0] + lane), load<T>(from[1] + lane), load<T>(from[2] + lane)};
  }
  V2<T> vector(const Array (&from)[3], const V2<T>&) const {
    return {load<T>(from[0] + lane), load<T>(from[1] + lane)};
  }
  V3<T> turn(const Array (&from)[3], const V3<T>& kind) const { return vector(from, kind); }
  T turn(const Array (&from)[3], const T&) const { return load<T>(from[2] + lane); }
  void put(const V3<T>& v, Array (&to)[3]) const {
    store(to[0] + lane, v.x), store(to[1] + lane, v.y), store(to[2] + lane, v.z);
  }
  void put(const V2<T>& v, Array (&to)[3]) const { store(to[0] + lane, v.x), store(to[1] + lane, v.y); }
  void put(const T& turn, Array (&to)[3]) const { store(to[2] + lane, turn); }
};

/// Calls memory for what the sweep will come to: blocks, and the grains of other chunks that one of them names.
inline void call_for(const ContactBlock* next, const ContactBlock* end, const double* grains, const double* loads) {
  constexpr int ahead = 6, soon = 3, line = 64;
  if (end - next <= ahead) return;
  const char* block = reinterpret_cast<const char*>(next + ahead);
  for (std::size_t at = 0; at < sizeof(ContactBlock); at += line) __builtin_prefetch(block + at);
  if (!next[soon].far) return;
  for (int lane = 0; lane < ContactBlock::size; ++lane) {
    const double* second = grains + next[soon].second[lane];
    __builtin_prefetch(second);
    __builtin_prefetch(second + line / sizeof(double));
    __builtin_prefetch(loads + next[soon].load_second[lane]);
  }
}

}  // namespace soilweave::dem
