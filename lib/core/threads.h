// Whether the threads that are asked for can be had.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave {

/// Throws UsageError, with how many there can be, unless this process can have `count` threads at once. Asked before
/// the work, since the OpenMP library ends the program without them.
void demand_threads(int count);

}  // namespace soilweave
