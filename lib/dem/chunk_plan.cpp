// In which order the passes of a step over the chunks of grains follow one another, and how threads share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/chunk_plan.h"

namespace soilweave::dem {

ChunkPlan::ChunkPlan(const std::vector<std::vector<std::uint32_t>>& reached, int threads)
    : shares_(static_cast<std::size_t>(threads)) {
  const std::size_t chunks = reached.size();
  const auto first_of = [&](std::size_t share) { return share * chunks / shares_.size(); };
  std::vector<bool> on_border(chunks), known(chunks);
  for (std::size_t s = 0; s < shares_.size(); ++s)
    for (std::size_t chunk = first_of(s); chunk < first_of(s + 1); ++chunk)
      for (const std::uint32_t other : reached[chunk])
        if (other >= first_of(s + 1)) on_border[other] = true;
  for (std::size_t s = 0; s < shares_.size(); ++s) {
    Share& share = shares_[s];
    const auto need = [&](std::size_t chunk) {
      if (chunk >= first_of(s + 1) || on_border[chunk] || known[chunk]) return;
      known[chunk] = true;
      share.in_need.push_back(static_cast<std::uint32_t>(chunk));
    };
    for (std::size_t chunk = first_of(s); chunk < first_of(s + 1); ++chunk) {
      const auto index = static_cast<std::uint32_t>(chunk);
      if (on_border[chunk]) border_.push_back(index);
      need(chunk);
      for (const std::uint32_t other : reached[chunk]) need(other);
      share.turns.push_back({index, static_cast<std::uint32_t>(share.in_need.size()), !on_border[chunk]});
    }
  }
}

}  // namespace soilweave::dem
