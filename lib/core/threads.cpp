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
    // A limit on processes or memory was reached. It is reported below, after the started threads have ended.
  }
  const int had = static_cast<int>(others.size()) + 1;
  over.count_down();
  for (std::thread& other : others) other.join();
  // A working thread needs memory beside its stack. Half of the startable threads proved too many, so the message
  // offers a quarter.
  if (had < count)
    throw UsageError(fmt::format(
        "--threads {}: this process may have {} at most (limits on processes or memory: ulimit -u, ulimit -v, those of "
        "a container); give --threads {}",
        count, had, std::max(1, had / 4)));
}

}  // namespace soilweave
