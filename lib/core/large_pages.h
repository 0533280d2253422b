// Memory on pages of 2 MiB, if the kernel grants them, for arrays that every step traverses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory_resource>
#include <vector>

namespace soilweave {

/// Returns the memory resource of the process. Threads may share it.
std::pmr::memory_resource& large_pages();

/// Allocator of the standard library that takes large pages.
template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(large_pages().allocate(n * sizeof(T), alignof(T))); }
  void deallocate(T* at, std::size_t n) { large_pages().deallocate(at, n * sizeof(T), alignof(T)); }
  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

/// Array on large pages, for data that every step traverses.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace soilweave
