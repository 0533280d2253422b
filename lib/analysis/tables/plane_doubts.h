// Doubts about planes that do not go on where the input ended.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/run/scenario.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns doubts about planes of the scenario that stand elsewhere than those of the packing on which grains press.
/// state: the prepared packing. Planes that are put in touch raise none.
std::vector<Doubt> moved_plane_doubts(const io::Snapshot& packing, const io::Snapshot& state,
                                      const dem::Scenario& scenario);

}  // namespace soilweave::analysis
