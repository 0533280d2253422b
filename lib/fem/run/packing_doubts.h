// Doubts about the packings of a two-scale run before its first step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "fem/model/model.h"

namespace soilweave::fem {

/// Returns the cell and material doubts of the packings (analysis/tables/doubts.h, material_doubts.h), and "jump" if
/// the contact law gives a packing another stress than its file has. Those of several packings name the first one that
/// they concern. packings: as read, one for all points or one per point. model: before its first step.
std::vector<Doubt> packing_doubts(const std::vector<io::Snapshot>& packings, const ModelSetup& setup,
                                  const Model& model);

}  // namespace soilweave::fem
