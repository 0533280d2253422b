// Checks that a state and its model belong together.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "dem/contact/model.h"
#include "files/records.h"

namespace soilweave::dem {

/// Returns the state. Throws DataError if the model lacks a material or geotextile that the state names.
/// Throws it also if a yarn passes through a periodic face, since yarns have no images.
/// A fabric may lie across a face if the positions of its nodes are not wrapped.
const io::Snapshot& described(const io::Snapshot& state, const Model& model);

/// Throws DataError if gravity (m/s2) or a plane's normal or velocity has a part along z and the packing is of disks.
void demand_in_plane(const io::Snapshot& state, const Vec3& gravity);

/// Returns a plane and an axis that it stands across, along which grains touch their own images through the faces of
/// the cell: such a plane bears what these contacts leave to it. Empty where grains leave as much free room along each
/// such axis as the largest is wide.
std::optional<std::pair<std::size_t, int>> plane_between_images(const io::Snapshot& state);

/// Throws DataError if nothing holds grains up: gravity (m/s2) acts, no plane opposes it, and no clamp holds a fabric.
void demand_footing(const io::Snapshot& state, const Vec3& gravity, bool clamped = false);

}  // namespace soilweave::dem
