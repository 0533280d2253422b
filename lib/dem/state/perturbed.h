// A twin of a packing with its grains moved a little at random.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "files/records.h"

namespace soilweave::dem {

/// Returns the packing with each grain moved at random by at most `fraction` of its radius along each axis.
/// Such a twin shows the scatter of a chaotic system. One seed gives the same twin everywhere.
/// Contacts keep their history.
io::Snapshot perturbed(const io::Snapshot& packing, double fraction, std::uint64_t seed);

}  // namespace soilweave::dem
