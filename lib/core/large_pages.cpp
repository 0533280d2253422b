// Blocks from the kernel, aligned to a large page, and a pool for smaller sizes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/large_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <new>

namespace soilweave {
namespace {

constexpr std::size_t page = std::size_t{2} << 20;
// Largest block that shares pages with others. Larger blocks come from the kernel and are returned to it.
constexpr std::size_t largest_shared = page / 4;

std::size_t rounded(std::size_t bytes) { return (bytes + page - 1) / page * page; }

class Kernel final : public std::pmr::memory_resource {
  void* do_allocate(std::size_t bytes, std::size_t) override {
    // Maps one page more than needed, and unmaps the parts outside the aligned block.
    const std::size_t length = rounded(bytes);
    void* const given =
        ::mmap(nullptr, length + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (given == MAP_FAILED) throw std::bad_alloc();
    char* const begin = static_cast<char*>(given);
    char* const aligned = begin + (page - reinterpret_cast<std::uintptr_t>(begin) % page) % page;
    if (aligned != begin) ::munmap(begin, static_cast<std::size_t>(aligned - begin));
    ::munmap(aligned + length, static_cast<std::size_t>(begin + page - aligned));
    ::madvise(aligned, length, MADV_HUGEPAGE);  // a request: if refused, the memory is only slower
    return aligned;
  }
  void do_deallocate(void* at, std::size_t bytes, std::size_t) override { ::munmap(at, rounded(bytes)); }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

// Pools for sizes up to `largest_shared`, whose chunks are whole pages.
class Shared final : public std::pmr::memory_resource {
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    return bytes > largest_shared ? kernel_.allocate(bytes, page) : pool_.allocate(bytes, alignment);
  }
  void do_deallocate(void* at, std::size_t bytes, std::size_t alignment) override {
    bytes > largest_shared ? kernel_.deallocate(at, bytes, page) : pool_.deallocate(at, bytes, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  Kernel kernel_;
  // Never returns memory to the kernel, because the pool has split its pages into blocks.
  std::pmr::monotonic_buffer_resource pages_{8 * page, &kernel_};
  std::pmr::synchronized_pool_resource pool_{{0, largest_shared}, &pages_};
};

}  // namespace

std::pmr::memory_resource& large_pages() {
  // Never destroyed, because other objects may return memory after its destruction.
  static Shared* const shared = new Shared;
  return *shared;
}

}  // namespace soilweave
