// Pairs of grains in blocks of eight: what a lane of the sweep reads and writes lies side by side.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "core/v3.h"
#include "dem/bodies.h"
#include "dem/cell_offset.h"
#include "dem/laws/contact.h"

namespace soilweave::dem {

/// Grains whose pairs one thread sweeps in one go: what the second cache holds, and as many as a representative volume
/// has, whose copies a large packing is often made of, one after the other.
inline constexpr std::size_t grains_per_chunk = 1000;
inline std::size_t chunks_of(std::size_t grains) { return (grains + grains_per_chunk - 1) / grains_per_chunk; }
/// Of a chunk; that of the next one, or how many there are.
inline std::size_t first_grain(std::size_t chunk, const Bodies& bodies) {
  return std::min(bodies.size(), chunk * grains_per_chunk);
}
inline std::size_t chunk_of(std::int32_t grain) { return static_cast<std::size_t>(grain) / grains_per_chunk; }

/// Eight pairs. Lane k of an array is pair k; lanes from `count` on are empty.
struct alignas(64) ContactBlock {
  static constexpr int size = 8, arrays = 8;  // pairs; arrays of numbers, which lie one after the other
  double shear[3][size];                      // N
  double rolling[3][size];                    // N m
  double twisting[size];                      // N m
  double normal_force[size];                  // N
  // Distances from the first grain, in bytes, first < second; in loads, that of the load that takes what acts on the
  // second grain, or of a pair with a plane on the only one.
  std::uint32_t first[size], second[size], load_second[size];
  std::uint16_t image[size];  // cell offset of the second grain, among Contacts::images
  // Bit k is pair k; folded: it reaches across the cell's faces.
  std::uint8_t touching = 0, sliding = 0, folded = 0;
  std::uint8_t count = 0;
  bool far = false;  // some second grain is of another chunk

  static std::uint8_t with_bit(std::uint8_t bits, int k, bool on) {
    return static_cast<std::uint8_t>((bits & ~(1u << k)) | (static_cast<unsigned>(on) << k));
  }

  static std::int32_t index(std::uint32_t distance) { return static_cast<std::int32_t>(distance / sizeof(Grain)); }
};

/// A pair as the neighbour search lists it.
struct Pair {
  std::int32_t first, second;
  CellOffset image;
};
/// Order of pairs by their grains.
inline bool before(const Pair& a, const Pair& b) {
  if (a.first != b.first) return a.first < b.first;
  return a.second != b.second ? a.second < b.second : a.image < b.image;
}

/// Those of a chunk, of pairs in the order of chunks.
template <class SomePair>
std::span<SomePair> of_chunk(std::span<SomePair> pairs, std::size_t chunk) {
  const auto from = [&](std::size_t c) {
    return std::partition_point(pairs.begin(), pairs.end(), [c](const Pair& p) { return chunk_of(p.first) < c; });
  };
  return {from(chunk), from(chunk + 1)};
}

/// Order of pairs in a list.
class PairOrder {
 public:
  explicit PairOrder(const Bodies& bodies) : material_(bodies.of_one_material ? nullptr : bodies.material.data()) {}
  /// Of what comes in the order of grains already.
  bool is_that_of_grains() const { return !material_; }
  bool same_couple(const Pair& a, const Pair& b) const {
    return !material_ || (material_[a.first] == material_[b.first] && material_[a.second] == material_[b.second]);
  }
  bool operator()(const Pair& a, const Pair& b) const {
    if (same_couple(a, b) || chunk_of(a.first) != chunk_of(b.first)) return before(a, b);
    return std::pair(material_[a.first], material_[a.second]) < std::pair(material_[b.first], material_[b.second]);
  }

 private:
  const std::int32_t* material_;  // none where all is of one
};

/// What is kept of one pair from step to step.
struct History {
  Memory<double> memory{{0, 0, 0}, {0, 0, 0}, 0};
  double normal_force = 0;  // N
  bool touching = false, sliding = false;
};

/// What a lane keeps.
History history_of(const ContactBlock& block, int lane);
void set_history(ContactBlock& block, int lane, const History& history);
/// Into a lane that holds zeros.
void copy_history(const ContactBlock& from, int lane, ContactBlock& to, int to_lane);

}  // namespace soilweave::dem
