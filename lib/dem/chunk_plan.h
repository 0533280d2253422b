// In which order the passes of a step over the chunks of grains follow one another, and how threads share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soilweave::dem {

/// A step passes over the grains to move them, over their pairs, and over the grains again to collect their loads. One
/// pass after the other would fetch every grain three times from a memory that is slower than the arithmetic. So a
/// thread moves, sweeps and collects chunk by chunk, while they lie in its cache: a chunk's pairs are swept when all
/// chunks that they reach have moved, and its loads collected then, since pairs belong to the chunk of their first
/// grain, the lower one. Each thread has a share of the chunks, one after the other, with as much work as any other
/// share; the last of each share are left to be swept by who is done first. These, and chunks that another share's
/// pairs reach, are moved before anything is swept, and collected when everything is.
class ChunkPlan {
 public:
  ChunkPlan() = default;
  /// reached: for each chunk the higher ones that its pairs reach; work: what each takes, in any unit, not 0.
  ChunkPlan(const std::vector<std::vector<std::uint32_t>>& reached, const std::vector<std::size_t>& work, int threads);

  /// Calls move(chunk), sweep(chunk) and collect(chunk) once for each chunk.
  template <class Move, class Sweep, class Collect>
  void run(const Move& move, const Sweep& sweep, const Collect& collect) const {
    const auto threads = static_cast<int>(shares_.size());
    if (threads == 1) return run(shares_.front(), move, sweep, collect);  // not even a team of one
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
  struct Turn {
    std::uint32_t chunk;
    std::uint32_t moved_until;  // how many in need must have moved before
    bool collect;
  };
  struct Share {
    std::vector<std::uint32_t> in_need;  // in the order in which their grains are
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

  std::vector<std::uint32_t> apart_, left_;  // moved and collected apart; those of them that no thread has as its own
  std::vector<Share> shares_;                // one for each thread
};

}  // namespace soilweave::dem
