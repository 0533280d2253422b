// Blocks from the kernel, aligned to a large page, and a pool for what is smaller.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/large_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <new>

namespace soilweave {
namespace {

constexpr std::size_t page = std::size_t{2} << 20;
// Larger blocks come from the kernel and go back to it; smaller ones share pages.
constexpr std::size_t largest_shared = page / 4;

std::size_t rounded(std::size_t bytes) { return (bytes + page - 1) / page * page; }

class Kernel final : public std::pmr::memory_resource {
  void* do_allocate(std::size_t bytes, std::size_t) override {
    // One page more than asked for, of which what lies beside a boundary of pages goes back.
    const std::size_t length = rounded(bytes);
    void* const given =
        ::mmap(nullptr, length + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (given == MAP_FAILED) throw std::bad_alloc();
    char* const begin = static_cast<char*>(given);
    char* const aligned = begin + (page - reinterpret_cast<std::uintptr_t>(begin) % page) % page;
    if (aligned != begin) ::munmap(begin, static_cast<std::size_t>(aligned - begin));
    ::munmap(aligned + length, static_cast<std::size_t>(begin + page - aligned));
    ::madvise(aligned, length, MADV_HUGEPAGE);  // a wish: without it all is the same, but slower
    return aligned;
  }
  void do_deallocate(void* at, std::size_t bytes, std::size_t) override { ::munmap(at, rounded(bytes)); }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

// Sizes up to `largest_shared` from pools, whose chunks are whole pages.
class Shared final : public std::pmr::memory_resource {
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    return bytes > largest_shared ? kernel_.allocate(bytes, page) : pool_.allocate(bytes, alignment);
  }
  void do_deallocate(void* at, std::size_t bytes, std::size_t alignment) override {
    bytes > largest_shared ? kernel_.deallocate(at, bytes, page) : pool_.deallocate(at, bytes, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  Kernel kernel_;
  // Never gives back to the kernel: chunks of a page are carved up for good.
  std::pmr::monotonic_buffer_resource pages_{8 * page, &kernel_};
  std::pmr::synchronized_pool_resource pool_{{0, largest_shared}, &pages_};
};

}  // namespace

std::pmr::memory_resource& large_pages() {
  // Left to the end of the process: others may give memory back later than it would be destroyed.
  static Shared* const shared = new Shared;
  return *shared;
}

}  // namespace soilweave
