// The lanes of a block of pairs that one register holds: how the sweep reads and writes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>

#include "dem/bodies.h"
#include "dem/contacts.h"
#include "dem/pair_geometry.h"

namespace soilweave::dem {

/// The lanes from k on.
template <class T>
struct BlockLanes {
  ContactBlock* block;
  std::size_t lane;
  double* numbers;  // of the block's first array, from the lane on

  BlockLanes() = default;
  BlockLanes(ContactBlock& of, std::size_t from) : block(&of), lane(from), numbers(of.shear[0] + from) {}

  static constexpr unsigned full = (1u << width<T>)-1;
  unsigned touching() const { return (unsigned{block->touching} >> lane) & full; }
  void set_masks(unsigned touching, unsigned sliding) const {
    const unsigned others = ~(full << lane);
    block->touching = static_cast<std::uint8_t>((block->touching & others) | (touching << lane));
    block->sliding = static_cast<std::uint8_t>((block->sliding & others) | (sliding << lane));
  }
  std::size_t first(std::size_t k) const { return block->first[lane + k]; }
  std::size_t second(std::size_t k) const { return block->second[lane + k]; }
  // In bytes: a distance among grains is one among loads without a division.
  double* load_first(std::size_t k, double* loads) const {
    return reinterpret_cast<double*>(reinterpret_cast<std::byte*>(loads) +
                                     first(k) * (sizeof(Load) / ContactBlock::grain_size));
  }
  double* load_second(std::size_t k, double* loads) const { return loads + block->load_second[lane + k]; }
  std::size_t image(std::size_t k) const { return block->image[lane + k]; }

  template <class Space>
  Vector<T, Space> shear() const {
    return vector(at(shear_force), Vector<T, Space>());
  }
  template <class Space>
  Turn<T, Space> rolling() const {
    return turn(at(rolling_moment), Turn<T, Space>());
  }
  T twisting() const { return load<T>(at(twisting_moment)); }
  T normal_force() const { return load<T>(at(normal)); }
  template <class V>
  void remember_shear(const V& shear) const {
    put(shear, at(shear_force));
  }
  template <class Space>
  void remember_moments(const Memory<T, Space>& memory) const {
    put(memory.rolling, at(rolling_moment));
    if constexpr (Space::twists) store(at(twisting_moment), memory.twisting);
  }
  void forget_moments() const { remember_moments(Memory<T, Spatial>{}); }
  void remember_normal_force(const T& force) const { store(at(normal), force); }

  /// The grains at one side of the pairs.
  struct Side {
    const double* grains;
    std::size_t distance[width<T>];
    const Grain& operator[](int k) const { return *reinterpret_cast<const Grain*>(grains + distance[k]); }
  };
  struct Ends {
    Side first, second;
  };
  Ends ends(const double* grains) const {
    Ends ends{{grains, {}}, {grains, {}}};
    for (std::size_t k = 0; k < width<T>; ++k) ends.first.distance[k] = first(k), ends.second.distance[k] = second(k);
    return ends;
  }
  /// Second grain less first; a cell offset comes with `shifts`, a row for each of Contacts::images.
  template <class Space>
  Vector<T, Space> branch(const Ends& ends, const Lane4* shifts) const {
    const auto between = [&](int k) { return ends.second[k].position - ends.first[k].position; };
    return Space::vector(block->folded ? columns<T>([&](int k) { return between(k) + shifts[image(k)]; })
                                       : columns<T>(between));
  }
  template <class Space>
  static Vector<T, Space> velocity(const Ends& ends) {
    return Space::vector(columns<T>([&](int k) { return ends.second[k].velocity - ends.first[k].velocity; }));
  }
  template <class Space>
  static std::pair<Turn<T, Space>, T> spin_and_radius(const Side& side) {
    const Columns<T> c = columns<T>([&](int k) { return side[k].spin; });
    return {Space::turn(c), c.d};
  }
  template <class Space>
  static void masses(const Ends& ends, Kinematics<T, Space>& kinematics) {
    double one[width<T>], two[width<T>];
    for (int k = 0; k < width<T>; ++k) one[k] = ends.first[k].velocity[3], two[k] = ends.second[k].velocity[3];
    kinematics.m1 = load<T>(one), kinematics.m2 = load<T>(two);
  }

 private:
  // The block's arrays of numbers, which lie one after the other.
  enum Array : std::size_t { shear_force = 0, rolling_moment = 3, twisting_moment = 6, normal = 7 };
  static_assert(offsetof(ContactBlock, normal_force) == normal * ContactBlock::size * sizeof(double));
  double* at(Array array) const { return numbers + array * ContactBlock::size; }

  // The last argument tells the kind. A turn in the plane is the third part.
  static V3<T> vector(const double* from, const V3<T>&) {
    return {load<T>(from), load<T>(from + ContactBlock::size), load<T>(from + 2 * ContactBlock::size)};
  }
  static V2<T> vector(const double* from, const V2<T>&) { return {load<T>(from), load<T>(from + ContactBlock::size)}; }
  static V3<T> turn(const double* from, const V3<T>& kind) { return vector(from, kind); }
  static T turn(const double* from, const T&) { return load<T>(from + 2 * ContactBlock::size); }
  static void put(const V3<T>& v, double* to) { put(V2<T>{v.x, v.y}, to), put(v.z, to); }
  static void put(const V2<T>& v, double* to) { store(to, v.x), store(to + ContactBlock::size, v.y); }
  static void put(const T& turn, double* to) { store(to + 2 * ContactBlock::size, turn); }
};

}  // namespace soilweave::dem
