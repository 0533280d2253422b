// Work shared by threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace soilweave {

/// Calls use(i) once for every i below n; each thread takes some that follow one another. One thread needs no team:
/// to make one costs as much as to step a hundred grains.
template <class Use>
void in_parallel(std::size_t n, int threads, const Use& use) {
  if (threads == 1) {
    for (std::size_t i = 0; i < n; ++i) use(i);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t i = 0; i < n; ++i) use(i);
}

}  // namespace soilweave
