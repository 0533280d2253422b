// The memory at hand, asked before much of it is taken.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace soilweave {

/// Bytes that this process may come to use: the machine's memory, or less where a limit is set (ulimit -v).
double memory_at_hand();

/// "take about 20 TB of memory, and 24 GB are at hand" where so many bytes are more than that; empty where they are
/// not.
std::string lack_of_memory(double bytes);

/// Throws DataError "WHAT take about ...: REMEDY" where so many bytes are more than that.
void demand_memory(double bytes, const std::string& what, const std::string& remedy);

/// Bytes that a grain takes while it moves, with its contacts and the list of its neighbours: a lower bound.
inline constexpr double bytes_of_grain = 1000;

/// "1.5 GB": bytes with three figures and a unit.
std::string bytes_text(double bytes);

}  // namespace soilweave
