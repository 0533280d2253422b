// Global heaps of HDF5 files: objects that overrun their place are found before HDF5 copies them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/global_heap.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace soilweave::io {
namespace {

void put(std::string& bytes, std::size_t at, std::uint64_t value) { std::memcpy(&bytes[at], &value, sizeof value); }

/// Returns a heap of 4096 bytes with one text of five bytes and free space, 8 bytes into a file.
std::string heap() {
  std::string bytes(8 + 4096, '\0');
  std::memcpy(&bytes[8], "GCOL\x01", 5);
  put(bytes, 16, 4096);
  bytes[24] = 1;  // object 1
  put(bytes, 32, 5);
  put(bytes, 24 + 24 + 8, 4096 - 16 - 24);  // free space up to the end, with its head
  return bytes;
}

TEST(GlobalHeap, ObjectsThatFillItAreWhole) {
  EXPECT_FALSE(has_broken_heap(heap()));
  EXPECT_FALSE(has_broken_heap("no heap at all"));
}

TEST(GlobalHeap, SizesThatRunOverItAreFound) {
  for (const std::uint64_t size : {std::uint64_t{4090}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    std::string bytes = heap();
    put(bytes, 32, size);
    EXPECT_TRUE(has_broken_heap(bytes)) << size;
  }
  std::string bytes = heap();
  put(bytes, 24 + 24 + 8, 0);
  EXPECT_TRUE(has_broken_heap(bytes)) << "free space without a size would be walked for ever";
}

TEST(GlobalHeap, TheSignatureAmongNumbersIsNoHeap) {
  std::string bytes = heap();
  put(bytes, 16, 12);
  put(bytes, 32, ~std::uint64_t{0});
  EXPECT_FALSE(has_broken_heap(bytes));
}

}  // namespace
}  // namespace soilweave::io
