// Doubts about a packing that was made all the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/doubts.h"
#include "files/records.h"
#include "packing/generate/standard.h"

namespace soilweave::packing {

/// Returns a doubt if the median diameter by mass of n grains is far from the curve's. A coarse tail of few, heavy
/// grains needs many grains.
std::optional<Doubt> grading_doubt(const Room& room, std::size_t grains);

/// Returns a doubt if the curve's first point leaves out more than a tenth of the mass.
std::optional<Doubt> finest_doubt(const Grading& curve);

/// Returns a doubt if the curve's median diameter is none of silt, sand, gravel or cobbles (ISO 14688-1).
std::optional<Doubt> size_doubt(const Grading& curve);

/// Returns a doubt if a largest diameter (--coarsest, m) leaves out nothing of the curve, as one in mm would.
std::optional<Doubt> coarsest_doubt(const Grading& curve, double coarsest);

/// Returns a doubt if the mean radius of a packing is that of boulders, as one in mm that was read as m would be.
std::optional<Doubt> radius_doubt(const io::Snapshot& state);

/// Returns a doubt if an imported packing has implausible lengths: if a periodic cell is so loose that it and its
/// grains seem to have different units, or else radius_doubt().
std::optional<Doubt> length_doubt(const io::Snapshot& state);

/// Returns doubts about the materials of a packing that is written as it was imported.
std::vector<Doubt> doubts_as_is(const io::Snapshot& state, const Contacts& contacts);

/// Returns doubts about a packing at rest under an isotropic pressure: its materials, its sizes, its grading, rattlers,
/// a coordination number below 3, the cell's width, q/p, overlap. room: curve and cell of a new packing. unbalanced:
/// unbalanced force at which the packing counted as at rest, doubted above a tenth.
std::vector<Doubt> doubts_about(const io::Snapshot& state, const Contacts& contacts, const std::optional<Room>& room,
                                double unbalanced = 0);

}  // namespace soilweave::packing
