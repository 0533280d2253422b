// Prepares a packing for a scenario, and checks that the two agree.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/engine/simulation.h"
#include "dem/run/scenario.h"
#include "files/records.h"

namespace soilweave::dem {

/// Returns the packing with the scenario's masses and planes.
/// Planes that are to touch the grains are moved there. Throws DataError if packing and scenario do not fit:
/// - the packing names materials or geotextiles that the scenario lacks;
/// - a stage loads an aperiodic axis, or a strain to record is no station;
/// - a yarn passes through a periodic face, a plane starts inside the grains, or a clamp holds nothing;
/// - gravity has nothing to press on, or a plane stands between grains and their images;
/// - a homogeneous start has no parts that face each other, or a critical drag has no aperiodic axis;
/// - masses are scaled although there is gravity;
/// - a plane, gravity or a stage leaves the plane of disks;
/// - a stage gives planes a friction angle, but there are none, or grains share their material;
/// - a stage compresses between plates that do not face each other along z.
io::Snapshot prepare(const io::Snapshot& packing, const Scenario& scenario);

/// Returns doubts about the plates of a prepared state.
std::vector<Doubt> plate_doubts(const io::Snapshot& state, const Scenario& scenario);

/// Throws DataError if a fixed time step exceeds the stability limit of the present contacts.
void demand_stable(Simulation& simulation, const Numerics& numerics);

/// Returns the nodes of geotextiles in an upright box (m), ascending.
std::vector<std::int32_t> nodes_within(const io::Snapshot& state, const Vec3& low, const Vec3& high);

}  // namespace soilweave::dem
