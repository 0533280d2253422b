// Checks that a state and its model belong together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/model.h"
#include "files/records.h"

namespace soilweave::dem {

/// Returns the state. Throws DataError if the model lacks a material or geotextile that the state names.
/// Throws it also if a yarn passes through a periodic face, since yarns have no images.
/// A fabric may lie across a face if the positions of its nodes are not wrapped.
const io::Snapshot& described(const io::Snapshot& state, const Model& model);

/// Throws DataError if nothing holds grains up: gravity acts along periodic axes, and no plane opposes it.
void demand_footing(const io::Snapshot& state, const Vec3& gravity);

}  // namespace soilweave::dem
