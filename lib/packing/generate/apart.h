// Grains that a straining cell moves only by contacts and yarns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/engine/simulation.h"

namespace soilweave::packing {

/// Keeps the absolute velocity of these grains when the cell's velocity gradient changes by `change`, 1/s.
void keep_apart(const std::vector<std::int32_t>& grains, const Mat3& change, dem::Simulation& simulation);

/// Stops these grains in space, at any strain rate of the cell. Called before every step, it makes the grains creep:
/// forces accelerate them within one step only.
void hold(const std::vector<std::int32_t>& grains, dem::Simulation& simulation);

}  // namespace soilweave::packing
