// Candidate pairs and the contacts among them, in blocks of eight: what a lane of the sweep reads and writes lies side
// by side. Pairs are sorted by (first, second, image); a pair whose grains do not touch holds zeros.
//
// Grains are cut into chunks by their index, and a pair belongs to the chunk of its first grain. A chunk begins with a
// new block. So neither the sums over a chunk nor their order depend on pairs that are listed without touching, on the
// width of a vector register or on the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/v3.h"
#include "dem/bodies.h"
#include "dem/cell_offset.h"
#include "dem/chunk_plan.h"
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
  // second grain.
  std::uint32_t first[size], second[size], load_second[size];
  std::uint16_t image[size];  // cell offset of the second grain, among Contacts::images
  // Bit k is pair k; folded: it reaches across the cell's faces.
  std::uint8_t touching = 0, sliding = 0, folded = 0;
  std::uint8_t count = 0;
  bool far = false;  // some second grain is of another chunk

  static std::int32_t index(std::uint32_t distance) { return static_cast<std::int32_t>(distance / sizeof(Grain)); }
};

/// A pair as the neighbour search lists it.
struct Pair {
  std::int32_t first, second;
  CellOffset image;
};
/// Order of pairs in a list.
inline bool before(const Pair& a, const Pair& b) {
  if (a.first != b.first) return a.first < b.first;
  return a.second != b.second ? a.second < b.second : a.image < b.image;
}

/// What is kept of one pair from step to step.
struct History {
  Memory<double> memory{{0, 0, 0}, {0, 0, 0}, 0};
  double normal_force = 0;  // N
  bool touching = false, sliding = false;
};

/// A grain and a plane closer than the skin.
struct PlanePair {
  std::int32_t grain, plane;
  std::uint32_t load;
  V3<double> normal{0, 0, 0};  // of the last sweep
  History history;
};

struct Contacts {
  std::vector<LargeVector<ContactBlock>> chunks;
  std::vector<PlanePair> planes;  // sorted by (grain, plane)
  // Cell offsets that occur: none first, the others sorted, and last one so far away that nothing touches over it.
  std::vector<CellOffset> images;
  // Of one pair each: what pairs of other chunks, and planes, do to a grain; pairs of its own chunk add to its own
  // load. They lie in Bodies::loads after those of the grains, in the order in which they are swept. Of grain b are
  // singles[singles_start[b]] up to singles[singles_start[b + 1]], in the order of its pairs, planes last.
  struct Single {
    std::uint32_t load;  // among Bodies::loads
    std::int32_t grain;
  };
  std::vector<Single> singles;
  std::vector<std::uint32_t> singles_start;
  int threads = 1;  // that share the chunks
  ChunkPlan plan;

  /// Lists these pairs, sorted by (first, second, image), and pairs with planes, sorted by (grain, plane). A pair that
  /// was listed before keeps its history. Loads are made to fit; they must be used up, that is zero. Throws DataError
  /// beyond 65,000 cell offsets or 33 million grains.
  void list(const std::vector<Pair>& pairs, std::vector<PlanePair> with_planes, Bodies& bodies);

  Pair pair(const ContactBlock& block, int lane) const;
  static History history(const ContactBlock& block, int lane);
  static void set_history(ContactBlock& block, int lane, const History& history);

 private:
  void look_across(const std::vector<Pair>& pairs);
  void name_singles(Bodies& bodies);

  std::vector<LargeVector<ContactBlock>> known_;     // by thread: of one chunk, while it is listed anew
  std::vector<std::vector<std::uint32_t>> reached_;  // by chunk: others that its pairs reach
  std::vector<std::vector<std::int32_t>> across_;    // by chunk: second grains of other chunks, pair by pair
  std::vector<std::uint32_t> next_;                  // place for another one in `singles`, of each grain
};

/// Sum of the magnitudes of all contact forces, N, contact by contact.
double force_sum(const Contacts& contacts);

}  // namespace soilweave::dem
