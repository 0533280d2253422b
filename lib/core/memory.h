// Available memory, checked before a large allocation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace soilweave {

/// Returns the bytes that this process may use: the machine's memory, or a lower ulimit -v or -d.
double memory_at_hand();

/// Returns the most bytes of memory that this process has used so far.
double peak_memory();

/// Returns "take about 20 TB of memory, and 24 GB are at hand", or an empty text if `bytes` are available.
std::string lack_of_memory(double bytes);

/// Throws DataError "WHAT take about ...: REMEDY" if `bytes` exceeds the available memory.
void demand_memory(double bytes, const std::string& what, const std::string& remedy);

/// Bytes per moving grain, with its contacts and neighbour list: a lower bound.
inline constexpr double bytes_of_grain = 1000;

/// Returns bytes with three figures and a unit: "1.5 GB".
std::string bytes_text(double bytes);

}  // namespace soilweave
