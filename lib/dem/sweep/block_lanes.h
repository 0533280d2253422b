// Access to the lanes of a block of pairs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "dem/contact/contacts.h"
#include "dem/contact/pair_geometry.h"
#include "dem/state/bodies.h"
#include "dem/sweep/pair_rows.h"

namespace soilweave::dem {

/// Lanes of a block from lane k on.
template <class T>
struct BlockLanes {
  /// Block of the lanes.
  ContactBlock* block;
  /// First lane.
  std::size_t lane;
  /// Place of the first lane in the block's first array.
  double* numbers;

  BlockLanes() = default;
  BlockLanes(ContactBlock& of, std::size_t from) : block(&of), lane(from), numbers(of.shear[0] + from) {}

  /// Mask of all lanes of a register.
  static constexpr unsigned full = (1u << width<T>)-1;
  /// Returns the mask of touching pairs, bit i for lane i.
  unsigned touching() const { return (unsigned{block->touching} >> lane) & full; }
  /// Returns the mask of pairs that reach across the cell's faces.
  unsigned folded() const { return (unsigned{block->folded} >> lane) & full; }
  /// Stores the masks of touching and sliding pairs.
  void set_masks(unsigned touching, unsigned sliding) const {
    const unsigned others = ~(full << lane);
    block->touching = static_cast<std::uint8_t>((block->touching & others) | (touching << lane));
    block->sliding = static_cast<std::uint8_t>((block->sliding & others) | (sliding << lane));
  }
  /// Returns the byte offset of the first grain of pair k.
  std::size_t first(std::size_t k) const { return block->first[lane + k]; }
  /// Returns the byte offset of the second grain of pair k.
  std::size_t second(std::size_t k) const { return block->second[lane + k]; }
  /// Returns the load of the first grain of pair k.
  double* load_first(std::size_t k, double* loads) const {
    constexpr std::size_t grain_over_load = sizeof(Grain) / sizeof(Load);
    return at_bytes(loads, first(k) / grain_over_load);
  }
  /// Returns the load of the second grain of pair k.
  double* load_second(std::size_t k, double* loads) const { return at_bytes(loads, block->load_second[lane + k]); }
  /// Returns the index of pair k's cell offset in Contacts::images.
  std::size_t image(std::size_t k) const { return block->image[lane + k]; }

  /// Returns the shear force, N.
  template <class Space>
  Along<T, Space> shear() const {
    return read(at(shear_force), Along<T, Space>());
  }
  /// Returns the rolling moment, N m.
  template <class Space>
  Turn<T, Space> rolling() const {
    return read(at(rolling_moment), Turn<T, Space>());
  }
  /// Returns the twisting moment, N m.
  T twisting() const { return load<T>(at(twisting_moment)); }
  /// Returns the normal force, N.
  T normal_force() const { return load<T>(at(normal)); }
  /// Stores the shear force.
  template <class V>
  void remember_shear(const V& shear) const {
    put(shear, at(shear_force));
  }
  /// Stores rolling and twisting moments.
  template <class Space>
  void remember_moments(const ContactHistory<T, Space>& history) const {
    put(history.rolling, at(rolling_moment));
    if constexpr (Space::twists) store(at(twisting_moment), history.twisting);
  }
  /// Sets all moments to zero.
  void forget_moments() const { remember_moments(ContactHistory<T, Spatial>{}); }
  /// Stores the normal force.
  void remember_normal_force(const T& force) const { store(at(normal), force); }

  /// Returns the first grains of the pairs.
  Side first_side(const std::byte* grains) const { return {grains, block->first + lane}; }
  /// Returns the second grains of the pairs.
  Side second_side(const std::byte* grains) const { return {grains, block->second + lane}; }
  /// Reads the rows of both grains. `shifts`: the vector of each of Contacts::images, m.
  template <class Space, bool moving>
  PairRows<T, Space> read(const std::byte* grains, const Lane4* shifts) const {
    const auto shift = [&](int k) -> const Lane4& { return shifts[image(static_cast<std::size_t>(k))]; };
    return read_rows<T, moving>(first_side(grains), second_side(grains), block->folded != 0, shift, Space());
  }
  /// Reads the masses of both grains, which only some laws need.
  template <class Space>
  void masses(const std::byte* grains, Kinematics<T, Space>& kinematics) const {
    double one[width<T>], two[width<T>];
    for (int k = 0; k < width<T>; ++k)
      one[k] = first_side(grains)[k].velocity[3], two[k] = second_side(grains)[k].velocity[3];
    kinematics.m1 = load<T>(one), kinematics.m2 = load<T>(two);
  }

 private:
  static double* at_bytes(double* from, std::size_t distance) {
    return reinterpret_cast<double*>(reinterpret_cast<std::byte*>(from) + distance);
  }
  /// Arrays of a block, one after the other.
  enum Array : std::size_t { shear_force = 0, rolling_moment = 3, twisting_moment = 6, normal = 7 };
  static_assert(offsetof(ContactBlock, normal_force) == normal * ContactBlock::size * sizeof(double));
  /// Returns an array, from the first lane on.
  double* at(Array array) const { return numbers + array * ContactBlock::size; }

  /// Reads a vector, or for disks a number, which lies in the third array.
  /// The last argument only selects the type.
  static V3<T> read(const double* from, const V3<T>&) {
    return {load<T>(from), load<T>(from + ContactBlock::size), load<T>(from + 2 * ContactBlock::size)};
  }
  static T read(const double* from, const T&) { return load<T>(from + 2 * ContactBlock::size); }
  static void put(const V3<T>& v, double* to) {
    store(to, v.x), store(to + ContactBlock::size, v.y);
    put(v.z, to);
  }
  static void put(const T& number, double* to) { store(to + 2 * ContactBlock::size, number); }
};

}  // namespace soilweave::dem
