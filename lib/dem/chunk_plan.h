// In which order the passes of a step over the chunks of grains follow one another, and how threads share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soilweave::dem {

/// A step passes over the grains to move them, over their pairs, and over the grains again to collect their loads. One
/// pass after the other fetches every grain three times from a memory that is slower than the arithmetic. So one thread
/// moves, sweeps and collects chunk by chunk, while they lie in its cache: a chunk's pairs are swept when all chunks
/// that they reach have moved, and its loads collected then, since pairs belong to the chunk of their first grain, the
/// lower one. Several threads take pass after pass, the same chunks in each: with as many caches, what waiting for one
/// another's chunks costs was measured to be as much as what it saves.
class ChunkPlan {
 public:
  ChunkPlan() = default;
  /// reached: for each chunk the higher ones that its pairs reach.
  ChunkPlan(const std::vector<std::vector<std::uint32_t>>& reached, int threads);

  /// Calls move(chunk), sweep(chunk) and collect(chunk) once for each chunk.
  template <class Move, class Sweep, class Collect>
  void run(const Move& move, const Sweep& sweep, const Collect& collect) const {
    if (threads_ == 1)
      run_chunks(move, sweep, collect);
    else
      run_passes(move, sweep, collect);
  }

 private:
  template <class Move, class Sweep, class Collect>
  void run_chunks(const Move& move, const Sweep& sweep, const Collect& collect) const {
    std::size_t moved = 0;
    for (std::size_t chunk = 0; chunk < moved_until_.size(); ++chunk) {
      for (; moved < moved_until_[chunk]; ++moved) move(in_need_[moved]);
      sweep(chunk);
      collect(chunk);
    }
  }
  template <class Move, class Sweep, class Collect>
  void run_passes(const Move& move, const Sweep& sweep, const Collect& collect) const {
    const std::size_t chunks = moved_until_.size();
#pragma omp parallel num_threads(threads_)
    {
#pragma omp for schedule(static)
      for (std::size_t chunk = 0; chunk < chunks; ++chunk) move(chunk);
#pragma omp for schedule(static)
      for (std::size_t chunk = 0; chunk < chunks; ++chunk) sweep(chunk);
#pragma omp for schedule(static)
      for (std::size_t chunk = 0; chunk < chunks; ++chunk) collect(chunk);
    }
  }

  int threads_ = 1;
  std::vector<std::uint32_t> in_need_;      // chunks, in the order in which they are needed
  std::vector<std::uint32_t> moved_until_;  // by chunk: how many of those must have moved before it is swept
};

}  // namespace soilweave::dem
