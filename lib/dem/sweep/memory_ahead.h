// Prefetches memory for the sweep, since the hardware cannot predict which grains a pair has.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"

namespace soilweave::dem {

/// Prefetches coming blocks into the L2 cache, and the second grains of pairs with their loads into the L1 cache.
/// A load that lies in memory would stop the sum of the forces, because it is read before it is added to.
inline void call_for(const ContactBlock* next, const ContactBlock* end, const std::byte* grains, const double* loads) {
  constexpr int ahead = 16, soon = 3, line = 64, second_cache = 2;
  if (end - next <= ahead) return;
  const char* block = reinterpret_cast<const char*>(next + ahead);
  for (std::size_t at = 0; at < sizeof(ContactBlock); at += line) __builtin_prefetch(block + at, 0, second_cache);
  for (int lane = 0; lane < ContactBlock::size; ++lane) {
    const std::byte* second = grains + next[soon].second[lane];
    __builtin_prefetch(second);
    __builtin_prefetch(second + line);
    __builtin_prefetch(reinterpret_cast<const std::byte*>(loads) + next[soon].load_second[lane], 1);
  }
}

}  // namespace soilweave::dem
