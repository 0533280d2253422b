// Check that the requested threads can be had.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave {

/// Throws UsageError with the possible number if `count` threads cannot be had.
/// Call it before the work: OpenMP ends the program if threads are missing.
void demand_threads(int count);

}  // namespace soilweave
