// A packing made ready for a scenario, and what the two must agree on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/scenario.h"
#include "dem/simulation.h"
#include "io/records.h"

namespace soilweave::dem {

/// A packing made ready for a scenario: density (masses follow) and mass scaling, planes, and materials checked against
/// the model. Planes that are to touch are put there. Throws DataError where the packing names materials or geotextiles
/// the scenario lacks, a stage loads an axis that is not periodic, a yarn passes through a periodic face, gravity has
/// nothing to press on, a plane starts inside the grains, a clamp holds nothing, a strain to record meets no
/// station, a homogeneous start has no parts that face each other, a critical drag no axis to swing along, or scaled
/// masses would fall.
io::Snapshot prepare(const io::Snapshot& packing, const Scenario& scenario);

/// Throws DataError where a fixed time step is over the stability limit of the simulation's present contacts.
void demand_stable(Simulation& simulation, const Numerics& numerics);

/// The nodes of geotextiles in an upright box, m, ascending.
std::vector<std::int32_t> nodes_within(const io::Snapshot& state, const Vec3& low, const Vec3& high);

}  // namespace soilweave::dem
