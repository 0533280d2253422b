// Candidate pairs and the contacts among them.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs lie in blocks of eight. A pair whose grains do not touch holds zeros.
//
// A pair belongs to the chunk of its first grain. Pairs of a chunk are sorted by materials, then by (first, second,
// image). Each pair of materials begins a new block, so that a block has one set of law parameters.
// Sums over a chunk do not depend on untouching pairs, register width or threads.
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
  /// Blocks of each chunk. The pool of large pages would round their memory up to powers of two.
  std::vector<std::vector<ContactBlock>> chunks;
  /// Pairs of grains and planes.
  PlaneContacts planes;
  /// Cell offsets that occur: zero, then the others sorted. The last one is for empty lanes, which never touch.
  std::vector<CellOffset> images;
  /// Load of a pair with a plane or with a grain of another chunk.
  /// Bodies::loads has the single loads after the loads of the grains, in the order of blocks, planes last.
  struct SingleLoad {
    /// Index into Bodies::loads.
    std::uint32_t load;
    /// Grain that the load acts on.
    std::int32_t grain;
  };
  /// Single loads, sorted by grain, and for each grain in the order of its pairs, planes last.
  std::vector<SingleLoad> single_loads;
  /// Index of each grain's first single load; the last entry is the number of single loads.
  std::vector<std::uint32_t> single_loads_start;
  /// Fields of history that only the law keeps; may be empty.
  std::span<const HistoryField> own_fields;
  /// Numbers of these fields by chunk: per block, an array of eight for each number (sweep/own_history.h).
  std::vector<std::vector<double>> own;
  /// Number of threads that share the chunks.
  int threads = 1;
  /// Order of the chunks in a step.
  ChunkPlan plan;

  /// Lists pairs, sorted by PairOrder, and pairs with planes. A pair that was listed before keeps its history.
  /// Resizes the loads, which must be zero.
  /// Throws DataError beyond 65,000 cell offsets or 33 million grains.
  void list(const std::vector<Pair>& pairs, std::vector<PlanePair> with_planes, Bodies& bodies);

  /// Sets the fields that only the law keeps. No pair may be listed yet.
  void keep_own(std::span<const HistoryField> fields);
  /// Returns the law's own numbers of a block, array by array.
  double* own_of(std::size_t chunk, std::size_t block) {
    return own[chunk].data() + block * own_numbers_ * ContactBlock::size;
  }
  const double* own_of(std::size_t chunk, std::size_t block) const {
    return own[chunk].data() + block * own_numbers_ * ContactBlock::size;
  }
  /// Returns how many numbers only the law keeps for a contact.
  std::size_t own_numbers() const { return own_numbers_; }
  /// Returns the pair in a lane of a block.
  Pair pair(const ContactBlock& block, int lane) const;

 private:
  /// Finds the pairs whose second grain is in another chunk.
  void look_across(const std::vector<Pair>& pairs);
  /// Assigns single loads to pairs and grains.
  void name_single_loads(Bodies& bodies);

  /// Numbers that only the law keeps, per contact.
  std::size_t own_numbers_ = 0;
  /// The law's own numbers of the blocks in known_.
  std::vector<std::vector<double>> known_own_;
  /// Previous blocks of the chunk that a thread lists anew, by thread.
  std::vector<std::vector<ContactBlock>> known_;
  /// Other chunks that a chunk's pairs reach.
  std::vector<std::vector<std::uint32_t>> reached_;
  /// Second grains in other chunks, pair by pair, by chunk.
  std::vector<std::vector<std::int32_t>> across_;
  /// Cost of each chunk in a step: one unit for each pair and for each grain.
  std::vector<std::size_t> work_;
  /// Next free place in `single_loads` of each grain.
  std::vector<std::uint32_t> next_;
};

/// Returns the shear force of each contact of disks as one number (space.h), N, in the order of the lists.
/// The numbers of the law's own vectors follow each force.
std::vector<double> shear_forces_of_disks(const Contacts& contacts);
/// Restores these shear forces. Throws DataError if their number differs.
void set_shear_forces_of_disks(const std::vector<double>& forces, Contacts& contacts);

/// Returns the sum of the magnitudes of all contact forces, N.
double force_sum(const Contacts& contacts);

}  // namespace soilweave::dem
