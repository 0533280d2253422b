// Available memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

#include "core/error.h"

namespace soilweave {

double memory_at_hand() {
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  for (const auto limit : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit set = {};
    if (getrlimit(limit, &set) == 0 && set.rlim_cur != RLIM_INFINITY)
      bytes = std::min(bytes, static_cast<double>(set.rlim_cur));
  }
  return bytes;
}

double peak_memory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

std::string lack_of_memory(double bytes) {
  const double at_hand = memory_at_hand();
  if (bytes <= at_hand) return "";
  return fmt::format("take about {} of memory, and {} are at hand", bytes_text(bytes), bytes_text(at_hand));
}

void demand_memory(double bytes, const std::string& what, const std::string& remedy) {
  if (const std::string lack = lack_of_memory(bytes); !lack.empty())
    throw DataError(fmt::format("{} {}: {}", what, lack, remedy));
}

std::string bytes_text(double bytes) {
  for (const char* unit : {"B", "kB", "MB", "GB", "TB", "PB"}) {
    if (bytes < 999.5) return fmt::format("{:.3g} {}", bytes, unit);
    bytes /= 1000;
  }
  return fmt::format("{:.3g} EB", bytes);
}

}  // namespace soilweave
