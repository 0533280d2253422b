// Sorts grains so that neighbours in space are neighbours in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "files/records.h"

namespace soilweave::packing {

/// Returns the state with its grains from row `first` on sorted box by box, one chunk (dem/contact/contacts.h) per box,
/// each with its identity. Touching grains then lie close in memory. Contacts follow their grains. Returns a state of
/// one chunk unchanged, and one whose yarns join these rows.
io::Snapshot in_spatial_order(io::Snapshot state, std::size_t first = 0);

}  // namespace soilweave::packing
