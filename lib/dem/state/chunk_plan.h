// Order of a step's passes over the chunks of grains, and their threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soilweave::dem {

/// Order of a step's passes: move the grains, sweep their pairs, collect their loads.
/// A thread makes all three passes over a chunk while it lies in the cache. A chunk is swept once all chunks
/// that its pairs reach have moved. Each thread has a contiguous share of equal work. The last chunks of
/// each share go to the first free thread. These last chunks, and chunks that another share reaches, move before
/// all sweeps and are collected after all sweeps.
class ChunkPlan {
 public:
  ChunkPlan() = default;
  /// `reached`: higher chunks that the pairs of each chunk reach. `work`: positive cost of each chunk, any unit.
  ChunkPlan(const std::vector<std::vector<std::uint32_t>>& reached, const std::vector<std::size_t>& work, int threads);

  /// Calls move(chunk), sweep(chunk) and collect(chunk) once for each chunk.
  template <class Move, class Sweep, class Collect>
  void run(const Move& move, const Sweep& sweep, const Collect& collect) const {
    const auto threads = static_cast<int>(shares_.size());
    // One thread needs no parallel region, which would take time to start.
    if (threads == 1) return run(shares_.front(), move, sweep, collect);
#pragma omp parallel num_threads(threads)
    {
#pragma omp for schedule(static)
      for (const std::uint32_t chunk : apart_) move(chunk);
#pragma omp for schedule(static, 1) nowait
      for (const Share& share : shares_) run(share, move, sweep, collect);
#pragma omp for schedule(dynamic, 1)
      for (const std::uint32_t chunk : left_) sweep(chunk);
#pragma omp for schedule(static)
      for (const std::uint32_t chunk : apart_) collect(chunk);
    }
  }

 private:
  /// One chunk to sweep, after enough chunks have moved.
  struct Turn {
    /// Chunk to sweep.
    std::uint32_t chunk;
    /// Number of chunks of in_need that must have moved first.
    std::uint32_t moved_until;
    /// Whether the chunk is collected right after.
    bool collect;
  };
  /// The chunks of one thread, in order.
  struct Share {
    /// Chunks to move, in the order of their grains.
    std::vector<std::uint32_t> in_need;
    /// Chunks to sweep, in order.
    std::vector<Turn> turns;
  };

  template <class Move, class Sweep, class Collect>
  static void run(const Share& share, const Move& move, const Sweep& sweep, const Collect& collect) {
    auto to_move = share.in_need.begin();
    for (const Turn& turn : share.turns) {
      for (; to_move != share.in_need.begin() + turn.moved_until; ++to_move) move(*to_move);
      sweep(turn.chunk);
      if (turn.collect) collect(turn.chunk);
    }
  }

  /// Chunks that move before and are collected after all sweeps; chunks among them that any free thread sweeps.
  std::vector<std::uint32_t> apart_, left_;
  /// One share per thread.
  std::vector<Share> shares_;
};

}  // namespace soilweave::dem
