// Starts the requested threads once, to see whether they can be had.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <latch>
#include <thread>
#include <vector>

#include "core/error.h"

namespace soilweave {

void demand_threads(int count) {
  std::latch over(1);
  std::vector<std::thread> others;
  try {
    while (static_cast<int>(others.size()) + 1 < count) others.emplace_back([&over] { over.wait(); });
  } catch (const std::exception&) {
    // Fewer threads than requested (a limit on processes or memory) are reported below, once the started ones have
    // ended.
  }
  const int had = static_cast<int>(others.size()) + 1;
  over.count_down();
  for (std::thread& other : others) other.join();
  // A working thread takes memory beside its stack. Half of the threads that start proved too many, so a quarter is
  // offered.
  if (had < count)
    throw UsageError(fmt::format(
        "--threads {}: this process may have {} at most (limits on processes or memory: ulimit -u, ulimit -v, those of "
        "a container); give --threads {}",
        count, had, std::max(1, had / 4)));
}

}  // namespace soilweave
