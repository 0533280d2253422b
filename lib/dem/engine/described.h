// Checks that a state and the model that will move it belong together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/model.h"
#include "files/records.h"

namespace soilweave::dem {

/// Returns the state. Throws DataError if a grain, plane or yarn names a material or geotextile that the model lacks.
/// Throws it also if a yarn passes through a periodic face, since yarns have no images. A fabric may lie across a face,
/// as long as the positions of its nodes are not wrapped.
const io::Snapshot& described(const io::Snapshot& state, const Model& model);

/// Throws DataError if nothing could hold grains up: gravity acts along periodic axes only, and no plane opposes it.
void demand_footing(const io::Snapshot& state, const Vec3& gravity);

}  // namespace soilweave::dem
