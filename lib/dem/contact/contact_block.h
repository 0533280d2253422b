// Pairs of grains in blocks of eight, one for each lane of the sweep.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/simd/v3.h"
#include "dem/contact/laws/contact.h"
#include "dem/state/bodies.h"
#include "dem/state/cell_offset.h"

namespace soilweave::dem {

/// Grains per chunk. One thread sweeps a chunk, which fits the L2 cache.
inline constexpr std::size_t grains_per_chunk = 1000;
/// Returns the number of chunks.
inline std::size_t chunks_of(std::size_t grains) { return (grains + grains_per_chunk - 1) / grains_per_chunk; }
/// Returns the first grain of `chunk`, or the number of grains past the last chunk.
inline std::size_t first_grain(std::size_t chunk, const Bodies& bodies) {
  return std::min(bodies.size(), chunk * grains_per_chunk);
}
/// Returns the chunk of a grain.
inline std::size_t chunk_of(std::int32_t grain) { return static_cast<std::size_t>(grain) / grains_per_chunk; }

/// Eight pairs. Lane k of an array is pair k; lanes from `count` on are empty.
struct alignas(64) ContactBlock {
  /// Pairs per block; number of consecutive arrays of doubles.
  static constexpr int size = 8, arrays = 8;
  /// Shear force, N.
  double shear[3][size];
  /// Rolling moment, N m.
  double rolling[3][size];
  /// Twisting moment, N m.
  double twisting[size];
  /// Normal force, N.
  double normal_force[size];
  /// Byte offsets of the two grains (first < second), and of the load of the second grain.
  /// In a pair with a plane, load_second is the load of the only grain.
  std::uint32_t first[size], second[size], load_second[size];
  /// Cell offset of the second grain, as an index into Contacts::images.
  std::uint16_t image[size];
  /// Masks, bit k for pair k. A folded pair reaches across the cell's faces.
  std::uint8_t touching = 0, sliding = 0, folded = 0;
  /// Number of pairs.
  std::uint8_t count = 0;

  /// Returns a mask with bit k set or cleared.
  static std::uint8_t with_bit(std::uint8_t bits, int k, bool on) {
    return static_cast<std::uint8_t>((bits & ~(1u << k)) | (static_cast<unsigned>(on) << k));
  }

  /// Returns the index of a grain from its byte offset.
  static std::int32_t index(std::uint32_t distance) { return static_cast<std::int32_t>(distance / sizeof(Grain)); }
};

/// A pair as the neighbour search lists it.
struct Pair {
  /// Indices of the grains, first < second.
  std::int32_t first, second;
  /// Cell offset of the second grain.
  CellOffset image;
};
/// Returns whether pair a precedes pair b in the order of grains.
inline bool before(const Pair& a, const Pair& b) {
  if (a.first != b.first) return a.first < b.first;
  return a.second != b.second ? a.second < b.second : a.image < b.image;
}

/// Returns the pairs of one chunk. `pairs` must be sorted by chunk.
template <class SomePair>
std::span<SomePair> of_chunk(std::span<SomePair> pairs, std::size_t chunk) {
  const auto from = [&](std::size_t c) {
    return std::partition_point(pairs.begin(), pairs.end(), [c](const Pair& p) { return chunk_of(p.first) < c; });
  };
  return {from(chunk), from(chunk + 1)};
}

/// Order of pairs in a list: by chunk, then by pair of materials, then by grains.
class PairOrder {
 public:
  explicit PairOrder(const Bodies& bodies) : material_(bodies.of_one_material ? nullptr : bodies.material.data()) {}
  /// Returns whether this order is the order by grains, because all grains have one material.
  bool is_that_of_grains() const { return !material_; }
  /// Returns whether two pairs have the same pair of materials.
  bool same_materials(const Pair& a, const Pair& b) const {
    return !material_ || (material_[a.first] == material_[b.first] && material_[a.second] == material_[b.second]);
  }
  /// Returns whether pair a comes before pair b.
  bool operator()(const Pair& a, const Pair& b) const {
    if (same_materials(a, b) || chunk_of(a.first) != chunk_of(b.first)) return before(a, b);
    return std::pair(material_[a.first], material_[a.second]) < std::pair(material_[b.first], material_[b.second]);
  }

 private:
  /// Materials of the grains; nullptr if all grains have one.
  const std::int32_t* material_;
};

/// History of one pair from step to step.
struct PairHistory {
  /// Shear force and moments.
  ContactHistory<double> history{{0, 0, 0}, {0, 0, 0}, 0};
  /// Normal force, N.
  double normal_force = 0;
  /// Whether the pair touches, and whether it slides.
  bool touching = false, sliding = false;
  /// Numbers that only its law keeps.
  std::vector<double> own = {};
};

/// Returns the history in a lane. `own`: the block's arrays of numbers that only the law keeps, `arrays` in number.
PairHistory history_of(const ContactBlock& block, int lane, const double* own = nullptr, std::size_t arrays = 0);
/// Stores a history in a lane, and the law's numbers in the arrays at `own`.
void set_history(ContactBlock& block, int lane, const PairHistory& history, double* own = nullptr);
/// Copies the history of a lane, with its numbers in the law's own `arrays`, into a lane of zeros.
void copy_history(const ContactBlock& from, const double* own, int lane, std::size_t arrays, ContactBlock& to,
                  double* own_to, int to_lane);

}  // namespace soilweave::dem
