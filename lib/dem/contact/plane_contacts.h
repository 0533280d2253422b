// Pairs of grains and planes, in blocks of eight.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "dem/contact/contact_block.h"

namespace soilweave::dem {

/// A grain and a plane closer than the skin, with their history.
struct PlanePair {
  /// Indices of grain and plane.
  std::int32_t grain, plane;
  /// History of the pair.
  PairHistory history = {};
};

/// Pairs of one plane with grains of one material and chunk. Each pair has a load of its own.
struct PlaneBlock {
  /// Pairs of the block.
  ContactBlock pairs;
  /// Index of the plane.
  std::int32_t plane;
};

/// All pairs of grains and planes of a simulation.
class PlaneContacts {
 public:
  /// Returns whether no pair is listed.
  bool empty() const { return blocks_.empty(); }
  /// Returns the blocks, plane by plane, sorted by material and grain.
  LargeVector<PlaneBlock>& blocks() { return blocks_; }
  const LargeVector<PlaneBlock>& blocks() const { return blocks_; }
  /// Returns the first block of each group, and last the number of blocks. A group has one plane, material and chunk.
  /// Sums over the pairs of a group do not depend on which distant pairs are listed.
  const std::vector<std::size_t>& groups() const { return groups_; }
  /// Returns the law's own numbers of a block, array by array (Contacts::own).
  double* own(std::size_t block) { return own_.data() + block * own_arrays_ * ContactBlock::size; }
  const double* own(std::size_t block) const { return own_.data() + block * own_arrays_ * ContactBlock::size; }
  /// Sets how many numbers only the law keeps for a contact. No pair may be listed yet.
  void keep_own(std::size_t arrays) { own_arrays_ = arrays; }
  /// Returns all listed pairs, in the order of the blocks.
  std::vector<PlanePair> pairs() const;

  /// Replaces the list. A pair that was listed before keeps its history.
  void list(std::vector<PlanePair> pairs, const Bodies& bodies);
  /// Assigns loads to the pairs from `first` on, in the order of the blocks.
  void set_loads(std::size_t first);

 private:
  /// Blocks of one plane, material and chunk each.
  LargeVector<PlaneBlock> blocks_;
  /// First block of each group, and the number of blocks.
  std::vector<std::size_t> groups_ = {0};
  /// Numbers that only the law keeps, per contact.
  std::size_t own_arrays_ = 0;
  /// Numbers that only the law keeps, block by block.
  std::vector<double> own_;
};

}  // namespace soilweave::dem
