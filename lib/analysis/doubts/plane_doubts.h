// Doubts about planes that do not start where the input ended.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/run/scenario.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns "moved-plane" for each plane of the packing on which grains press, if the scenario puts it elsewhere. state:
/// the prepared packing. Planes that the scenario puts in touch with the grains are not judged.
std::vector<Doubt> moved_plane_doubts(const io::Snapshot& packing, const io::Snapshot& state,
                                      const dem::Scenario& scenario);

}  // namespace soilweave::analysis
