// Doubts about tables of a scenario that its packing does not use, and about values in another unit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/doubts.h"
#include "dem/run/scenario.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns "unused-material" if no grain, node or plane of the state has a [[material]] of the scenario, and
/// "unused-geotextile" if no yarn has a [[geotextile]]. begun: the state before the first step, with all planes.
std::vector<Doubt> unused_doubts(const io::Snapshot& begun, const dem::Scenario& scenario);

/// Returns "spacing" if the greatest tension of a curve, over the mean length of its yarns, differs by a factor of more
/// than 1.5 from the strength in the curve's file, so that the curve is that of yarns further apart or nearer.
/// Otherwise returns "yarn" if it is no strength of a geotextile: below 3 or above 3000 kN/m. A mesh has square
/// openings, so that yarns are as far apart as they are long.
std::vector<Doubt> yarn_doubts(const io::Snapshot& begun, const dem::Scenario& scenario);

/// Returns "tolerance" if `off`, the value of `key`, is above a tenth. It is the share by which forces or stresses may
/// be off in a state that counts as at rest.
std::vector<Doubt> tolerance_doubts(const std::string& key, double off);

/// Returns "tolerance" if stations count as settled with an unbalanced force or stresses off by more than a tenth.
std::vector<Doubt> tolerance_doubts(const dem::Tolerances& tolerances);

/// Returns all doubts of this file.
std::vector<Doubt> input_doubts(const io::Snapshot& begun, const dem::Scenario& scenario);

}  // namespace soilweave::analysis
