// In which order the passes of a step over the chunks of grains follow one another, and how threads share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/chunk_plan.h"

namespace soilweave::dem {

ChunkPlan::ChunkPlan(const std::vector<std::vector<std::uint32_t>>& reached, int threads)
    : shares_(static_cast<std::size_t>(threads)) {
  const std::size_t chunks = reached.size(), count = shares_.size();
  const auto first_of = [&](std::size_t share) { return share * chunks / count; };
  // How much of a share is left for all evens out what the shares differ in, and cores.
  const auto own_end = [&](std::size_t share) {
    constexpr std::size_t one_of = 7;
    const std::size_t own = first_of(share + 1) - first_of(share);
    return first_of(share + 1) - (count > 1 ? (own + one_of / 2) / one_of : 0);
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
