// Grains that a straining cell moves only through contacts and yarns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/engine/simulation.h"

namespace soilweave::packing {

/// Keeps the absolute velocity of these grains when the cell's velocity gradient changes by `change`, 1/s: their
/// velocity relative to the cell's affine motion changes the other way.
void keep_apart(const std::vector<std::int32_t>& grains, const Mat3& change, dem::Simulation& simulation);

/// Stops these grains in space, whatever the cell's strain rate is. Called before every step, it leaves them the motion
/// that their forces cause within one step: they creep.
void hold(const std::vector<std::int32_t>& grains, dem::Simulation& simulation);

}  // namespace soilweave::packing
