// In which order the passes of a step over the chunks of grains follow one another, and how threads share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/chunk_plan.h"

namespace soilweave::dem {

ChunkPlan::ChunkPlan(const std::vector<std::vector<std::uint32_t>>& reached, int threads) : threads_(threads) {
  std::vector<bool> known(reached.size());
  const auto need = [&](std::size_t chunk) {
    if (!known[chunk]) in_need_.push_back(static_cast<std::uint32_t>(chunk));
    known[chunk] = true;
  };
  for (std::size_t chunk = 0; chunk < reached.size(); ++chunk) {
    need(chunk);
    for (const std::uint32_t other : reached[chunk]) need(other);
    moved_until_.push_back(static_cast<std::uint32_t>(in_need_.size()));
  }
}

}  // namespace soilweave::dem
