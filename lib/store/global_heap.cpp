// Walks through global heaps object by object.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/global_heap.h"

#include <cstdint>
#include <cstring>

namespace soilweave::io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view signature = "GCOL\x01"sv;
constexpr std::size_t heap_header = 16, object_header = 16, least_heap = 4096;

template <class Whole>
Whole whole_at(std::string_view bytes, std::size_t at) {
  Whole value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// Returns whether the objects of one heap, its free space (object 0) included, end where the heap ends.
bool is_whole(std::string_view heap) {
  std::size_t at = heap_header;
  while (heap.size() - at >= object_header) {
    const auto index = whole_at<std::uint16_t>(heap, at);
    const auto size = whole_at<std::uint64_t>(heap, at + 8);
    const std::size_t left = heap.size() - at;
    if (size > left) return false;
    const std::size_t taken = index == 0 ? size : object_header + (size + 7) / 8 * 8;
    if (taken < object_header || taken > left) return false;
    at += taken;
  }
  return true;
}

}  // namespace

bool has_broken_heap(std::string_view bytes) {
  for (std::size_t at = bytes.find(signature); at != bytes.npos; at = bytes.find(signature, at + 1)) {
    if (bytes.size() - at < heap_header) return false;
    // The signature may also occur among numbers; then no plausible size follows.
    const auto size = whole_at<std::uint64_t>(bytes, at + 8);
    if (size < least_heap || size % 8 != 0 || size > bytes.size() - at) continue;
    if (!is_whole(bytes.substr(at, size))) return true;
  }
  return false;
}

}  // namespace soilweave::io
