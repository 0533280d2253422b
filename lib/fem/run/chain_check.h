// Sizes of a geosynthetic against the boundary that it follows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/settings.h"
#include "fem/model/model.h"

namespace soilweave::fem {

/// Notes a mistake for a radius, spacing or overhang that is larger than the boundary allows, as millimetres without
/// their unit are. `setup` has its boundaries, its spacing and its overhang.
void check_chain(Settings& geosynthetic, const ModelSetup& setup, double radius);

}  // namespace soilweave::fem
