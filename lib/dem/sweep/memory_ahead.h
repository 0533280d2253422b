// Prefetches memory for the sweep, since the hardware cannot predict which grains a pair has.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"

namespace soilweave::dem {

/// Prefetches coming blocks into the L2 cache, and second grains that lie in other chunks.
inline void call_for(const ContactBlock* next, const ContactBlock* end, const std::byte* grains) {
  constexpr int ahead = 16, soon = 3, line = 64, second_cache = 2;
  if (end - next <= ahead) return;
  const char* block = reinterpret_cast<const char*>(next + ahead);
  for (std::size_t at = 0; at < sizeof(ContactBlock); at += line) __builtin_prefetch(block + at, 0, second_cache);
  if (!next[soon].far) return;
  for (int lane = 0; lane < ContactBlock::size; ++lane) {
    const std::byte* second = grains + next[soon].second[lane];
    __builtin_prefetch(second);
    __builtin_prefetch(second + line);
  }
}

}  // namespace soilweave::dem
