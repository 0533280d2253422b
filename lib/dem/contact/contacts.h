// Candidate pairs and the contacts among them.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs lie in blocks of eight. A pair whose grains do not touch holds zeros.
//
// Grains are cut into chunks by their index, and a pair belongs to the chunk of its first grain. Within a chunk, pairs
// of one pair of materials follow one another, sorted by (first, second, image). Each chunk, and each pair of
// materials, begins a new block, so that one set of law parameters serves a block. Hence the sums over a chunk do not
// depend on pairs that do not touch, on the width of a register, or on the number of threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem/contact/contact_block.h"
#include "dem/contact/plane_contacts.h"
#include "dem/state/bodies.h"
#include "dem/state/chunk_plan.h"

namespace soilweave::dem {

/// All pairs of a simulation, in chunks of blocks, with the history of those that touch.
struct Contacts {
  std::vector<LargeVector<ContactBlock>> chunks;
  /// Pairs of grains and planes.
  PlaneContacts planes;
  // Cell offsets that occur: zero, then the others sorted. No pair touches across the last.
  std::vector<CellOffset> images;
  // Loads of pairs with grains of other chunks, and with planes. They follow the loads of the grains in Bodies::loads,
  // in the order of the blocks, planes last. Grain b has single_loads[single_loads_start[b]] up to
  // single_loads[single_loads_start[b + 1]], in the order of its pairs, planes last.
  struct SingleLoad {
    /// Index into Bodies::loads.
    std::uint32_t load;
    /// Grain that the load acts on.
    std::int32_t grain;
  };
  std::vector<SingleLoad> single_loads;
  std::vector<std::uint32_t> single_loads_start;
  // Fields of history that only the law keeps, and their numbers by chunk (sweep/own_history.h): for each block an
  // array of eight for each number. Empty for laws without such fields.
  std::span<const HistoryField> own_fields;
  std::vector<std::vector<double>> own;
  /// Number of threads that share the chunks.
  int threads = 1;
  /// Order of the chunks in a step.
  ChunkPlan plan;

  /// Lists these pairs, in the order of lists, and pairs with planes. A pair that was listed before keeps its history.
  /// Resizes the loads, which must be zero. Throws DataError beyond 65,000 cell offsets or 33 million grains.
  void list(const std::vector<Pair>& pairs, std::vector<PlanePair> with_planes, Bodies& bodies);

  /// Sets the fields that only the law keeps. Must be called before any pair is listed.
  void keep_own(std::span<const HistoryField> fields);
  /// Returns the law's own numbers of a block, array by array.
  double* own_of(std::size_t chunk, std::size_t block) {
    return own[chunk].data() + block * own_numbers_ * ContactBlock::size;
  }
  const double* own_of(std::size_t chunk, std::size_t block) const {
    return own[chunk].data() + block * own_numbers_ * ContactBlock::size;
  }
  /// Returns how many numbers a contact keeps for these fields.
  std::size_t own_numbers() const { return own_numbers_; }
  /// Returns the pair in a lane of a block.
  Pair pair(const ContactBlock& block, int lane) const;

 private:
  void look_across(const std::vector<Pair>& pairs);
  void name_single_loads(Bodies& bodies);

  std::size_t own_numbers_ = 0;
  /// Like known_, the law's own numbers.
  std::vector<std::vector<double>> known_own_;
  /// Blocks of one chunk while it is listed anew, by thread.
  std::vector<LargeVector<ContactBlock>> known_;
  /// Other chunks that a chunk's pairs reach.
  std::vector<std::vector<std::uint32_t>> reached_;
  /// Second grains in other chunks, pair by pair, by chunk.
  std::vector<std::vector<std::int32_t>> across_;
  /// Cost of a chunk in a step; 1 for a pair or a grain.
  std::vector<std::size_t> work_;
  /// Next free place in `single_loads` of each grain.
  std::vector<std::uint32_t> next_;
};

/// Returns the shear forces of the contacts of disks, N, as the numbers that are kept (space.h), in the order of lists.
/// Each is followed by the vectors that only the law keeps.
std::vector<double> shear_forces_of_disks(const Contacts& contacts);
/// Restores these shear forces. Throws DataError if their number differs.
void set_shear_forces_of_disks(const std::vector<double>& forces, Contacts& contacts);

/// Returns the sum of the magnitudes of all contact forces, N, summed contact by contact.
double force_sum(const Contacts& contacts);

}  // namespace soilweave::dem
