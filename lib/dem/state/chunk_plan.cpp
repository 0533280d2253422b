// Order of the passes of a step over the chunks of grains, and its division among threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/state/chunk_plan.h"

#include <algorithm>
#include <numeric>

namespace soilweave::dem {

ChunkPlan::ChunkPlan(const std::vector<std::vector<std::uint32_t>>& reached, const std::vector<std::size_t>& work,
                     int threads)
    : shares_(static_cast<std::size_t>(threads)) {
  const std::size_t chunks = reached.size(), count = shares_.size();
  std::vector<std::size_t> before(chunks + 1, 0);  // work of all chunks before each
  std::partial_sum(work.begin(), work.end(), before.begin() + 1);
  const auto chunk_at = [&](std::size_t done) {
    return static_cast<std::size_t>(std::lower_bound(before.begin(), before.end(), done) - before.begin());
  };
  const auto first_of = [&](std::size_t share) { return chunk_at(share * before.back() / count); };
  // The last seventh of each thread's chunks may be taken by any thread. That evens out chunks of unequal cost and slow
  // cores.
  const auto own_end = [&](std::size_t share) {
    constexpr std::size_t one_of = 7;
    const std::size_t begin = before[first_of(share)], end = before[first_of(share + 1)];
    return count > 1 ? chunk_at(end - (end - begin) / one_of) : chunks;
  };
  std::vector<bool> apart(chunks), known(chunks);
  for (std::size_t s = 0; s < count; ++s)
    for (std::size_t chunk = first_of(s); chunk < first_of(s + 1); ++chunk) {
      if (chunk >= own_end(s)) left_.push_back(static_cast<std::uint32_t>(chunk)), apart[chunk] = true;
      for (const std::uint32_t other : reached[chunk])
        if (other >= first_of(s + 1)) apart[other] = true;
    }
  for (std::size_t s = 0; s < count; ++s) {
    Share& share = shares_[s];
    const auto need = [&](std::size_t chunk) {
      if (apart[chunk] || known[chunk]) return;
      known[chunk] = true;
      share.in_need.push_back(static_cast<std::uint32_t>(chunk));
    };
    for (std::size_t chunk = first_of(s); chunk < own_end(s); ++chunk) {
      const auto index = static_cast<std::uint32_t>(chunk);
      need(chunk);
      for (const std::uint32_t other : reached[chunk]) need(other);
      share.turns.push_back({index, static_cast<std::uint32_t>(share.in_need.size()), !apart[chunk]});
    }
  }
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    if (apart[chunk]) apart_.push_back(static_cast<std::uint32_t>(chunk));
}

}  // namespace soilweave::dem
