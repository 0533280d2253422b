// Grains that a straining cell moves through contacts and yarns alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/simulation.h"

namespace soilweave::packing {

/// Leaves these grains their speed in space after the cell's velocity gradient changed by `change`, 1/s: their
/// velocities about the cell's affine motion change the other way.
void keep_apart(const std::vector<std::int32_t>& grains, const Mat3& change, dem::Simulation& simulation);

}  // namespace soilweave::packing
