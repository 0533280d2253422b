// Check that the requested threads can be had.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave {

/// Throws UsageError with the possible number unless this process can have `count` threads at once. Call it before the
/// work, since the OpenMP library ends the program if threads are missing.
void demand_threads(int count);

}  // namespace soilweave
