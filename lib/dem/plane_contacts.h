// Pairs of grains and planes, in blocks of eight.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "dem/contact_block.h"

namespace soilweave::dem {

/// A grain and a plane closer than the skin, and what is known of them.
struct PlanePair {
  std::int32_t grain, plane;
  History history = {};
};

/// Pairs of one plane with grains of one material: there are no second grains, and each pair has a load of its own.
struct PlaneBlock {
  ContactBlock pairs;
  std::int32_t plane;
};

class PlaneContacts {
 public:
  bool empty() const { return blocks_.empty(); }
  /// Of a plane one after the other, by material and grain.
  LargeVector<PlaneBlock>& blocks() { return blocks_; }
  const LargeVector<PlaneBlock>& blocks() const { return blocks_; }
  /// All that are listed, in the order of the blocks.
  std::vector<PlanePair> pairs() const;

  /// Lists these pairs instead. One that was listed before keeps its history.
  void list(std::vector<PlanePair> pairs, const Bodies& bodies);
  /// Loads follow one another from this one on, in the order of the blocks.
  void set_loads(std::size_t first);

 private:
  LargeVector<PlaneBlock> blocks_;
};

}  // namespace soilweave::dem
