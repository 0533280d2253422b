// Memory that a sweep will come to is called for before: the hardware does not foresee which grains pairs will name.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/bodies.h"
#include "dem/contacts.h"

namespace soilweave::dem {

/// Calls for blocks to come, and the grains of other chunks that one of them names.
inline void call_for(const ContactBlock* next, const ContactBlock* end, const std::byte* grains,
                     const std::byte* loads) {
  constexpr int ahead = 6, soon = 3, line = 64;
  if (end - next <= ahead) return;
  const char* block = reinterpret_cast<const char*>(next + ahead);
  for (std::size_t at = 0; at < sizeof(ContactBlock); at += line) __builtin_prefetch(block + at);
  if (!next[soon].far) return;
  for (int lane = 0; lane < ContactBlock::size; ++lane) {
    const std::byte* second = grains + next[soon].second[lane];
    __builtin_prefetch(second);
    __builtin_prefetch(second + line);
    __builtin_prefetch(loads + next[soon].load_second[lane]);
  }
}

/// Calls for the grains of a chunk to come and their loads, some with every block of the present one.
class ChunkToCome {
 public:
  ChunkToCome(const Bodies& bodies, std::size_t chunk, std::size_t blocks_before) {
    const std::size_t begin = first_grain(chunk, bodies), end = first_grain(chunk + 1, bodies);
    grain_ = bodies.grains.data() + begin, end_ = bodies.grains.data() + end;
    load_ = bodies.loads.data() + begin;
    at_once_ = blocks_before > 0 ? (end - begin) / blocks_before + 1 : 0;
  }

  void call() {
    constexpr int second_cache = 2;
    for (std::size_t n = 0; n < at_once_ && grain_ != end_; ++n, ++grain_, ++load_) {
      __builtin_prefetch(&grain_->position, 0, second_cache);
      __builtin_prefetch(&grain_->spin, 0, second_cache);
      __builtin_prefetch(load_, 1, second_cache);
    }
  }

 private:
  const Grain *grain_, *end_;
  const Load* load_;
  std::size_t at_once_;
};

}  // namespace soilweave::dem
