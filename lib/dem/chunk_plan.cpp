// In which order the passes of a step over the chunks of grains follow one another, and how threads share them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/chunk_plan.h"

#include <algorithm>
#include <cmath>

namespace soilweave::dem {
namespace {

using Reached = std::vector<std::vector<std::uint32_t>>;

// first[s] is the first chunk of share s.
std::vector<bool> border_of(const Reached& reached, const std::vector<std::size_t>& first) {
  std::vector<bool> border(reached.size());
  for (std::size_t s = 0; s + 1 < first.size(); ++s)
    for (std::size_t chunk = first[s]; chunk < first[s + 1]; ++chunk)
      for (const std::uint32_t other : reached[chunk])
        if (other >= first[s + 1]) border[other] = true;
  return border;
}

// The border is moved and collected by all alike: whose share has much of it is given more chunks to sweep.
std::vector<std::size_t> balanced(const Reached& reached, std::size_t shares) {
  constexpr double moving = 0.35;  // and collecting a chunk, over sweeping it
  std::vector<std::size_t> first(shares + 1), of_border(shares);
  for (std::size_t s = 0; s <= shares; ++s) first[s] = s * reached.size() / shares;
  const std::vector<bool> border = border_of(reached, first);
  std::size_t all = 0;
  for (std::size_t s = 0; s < shares; ++s) {
    for (std::size_t chunk = first[s]; chunk < first[s + 1]; ++chunk) of_border[s] += border[chunk];
    all += of_border[s];
  }
  const double mean = static_cast<double>(all) / static_cast<double>(shares);
  double more = 0;
  for (std::size_t s = 0; s + 1 < shares; ++s) {
    more += moving / (1 + moving) * (static_cast<double>(of_border[s]) - mean);
    const double cut = static_cast<double>(first[s + 1]) + std::round(more);
    first[s + 1] =
        static_cast<std::size_t>(std::clamp(cut, static_cast<double>(first[s]), static_cast<double>(reached.size())));
  }
  return first;
}

}  // namespace

ChunkPlan::ChunkPlan(const Reached& reached, int threads) : shares_(static_cast<std::size_t>(threads)) {
  const std::vector<std::size_t> first = balanced(reached, shares_.size());
  const std::vector<bool> on_border = border_of(reached, first);
  std::vector<bool> known(reached.size());
  for (std::size_t s = 0; s < shares_.size(); ++s) {
    Share& share = shares_[s];
    const auto need = [&](std::size_t chunk) {
      if (chunk >= first[s + 1] || on_border[chunk] || known[chunk]) return;
      known[chunk] = true;
      share.in_need.push_back(static_cast<std::uint32_t>(chunk));
    };
    for (std::size_t chunk = first[s]; chunk < first[s + 1]; ++chunk) {
      const auto index = static_cast<std::uint32_t>(chunk);
      if (on_border[chunk]) border_.push_back(index);
      need(chunk);
      for (const std::uint32_t other : reached[chunk]) need(other);
      share.turns.push_back({index, static_cast<std::uint32_t>(share.in_need.size()), !on_border[chunk]});
    }
  }
}

}  // namespace soilweave::dem
