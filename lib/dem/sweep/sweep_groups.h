// Data between the stages of a sweep.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "dem/sweep/block_lanes.h"
#include "dem/sweep/contact_sweep.h"
#include "dem/sweep/contact_work.h"

namespace soilweave::dem {

/// Sums of a step over the contacts of a chunk.
template <class Lanes>
struct StepSums {
  /// Work and dissipation (contact_work.h), J.
  Lane4 work{};
  /// Largest overlap, per lane.
  Lanes overlap{};
  /// Affine stiffness, if requested, N m.
  Lane4 affine_stiffness{};
  std::int64_t contacts = 0;

  void put_into(SweepSums& s) const {
    s.tangential_work -= 0.5 * work[0];
    s.frictional += work[1], s.rolling_plastic += work[2], s.viscous += work[3];
    for (int lane = 0; lane < width<Lanes>; ++lane) s.largest_overlap = std::max(s.largest_overlap, overlap[lane]);
    s.contacts += contacts;
  }
};

/// Input of a sweep besides the pairs.
struct Surroundings {
  /// Grains.
  const Bodies& bodies;
  /// Vectors of Contacts::images, m.
  const std::vector<Lane4>& shifts;
  /// Motion of the deforming cell.
  AffineMotion affine;
  /// Time step, s.
  double dt;
  /// Whether all pairs and grains stay in the cache from step to step.
  bool in_cache;
  /// Loads of the grains.
  double* loads;
  /// Stiffness, laid out like the loads.
  double* stiffness;
  /// Forces of this chunk's pairs across the cell's faces, summed by image.
  double* across;
  /// First block of this chunk.
  const ContactBlock* first_block;
  /// The law's own numbers of this chunk (own_history.h).
  double* own;

  const std::byte* grains() const { return reinterpret_cast<const std::byte*>(bodies.grains.data()); }
  /// Returns the place of the lane in the first of the law's own arrays of a block.
  template <class Fields, class Lanes>
  double* own_of(const BlockLanes<Lanes>& lanes) const {
    if constexpr (Fields::arrays == 0)
      return nullptr;
    else
      return own + static_cast<std::size_t>(lanes.block - first_block) * Fields::arrays * ContactBlock::size +
             lanes.lane;
  }
};

/// Pairs of one register, with their results of the stages so far.
template <class Lanes, class Space>
struct Group {
  BlockLanes<Lanes> lanes;
  unsigned touching;
  PairMotion<Lanes, Space> motion;
  PairGeometry<Lanes, Space> geometry;
  Work<Lanes> work;
};
/// Number of groups in a batch, which fits the first cache.
inline constexpr std::size_t batch_size = 8;
template <class Lanes, class Space>
using Batch = std::span<Group<Lanes, Space>>;

}  // namespace soilweave::dem
