// Sorts grains so that neighbours in space are neighbours in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/records.h"

namespace soilweave::packing {

/// Returns the grains sorted box by box, one chunk (dem/contact/contacts.h) per box, each with its identity. Touching
/// grains then lie close in memory. Returns a packing unchanged if it has only one chunk, or has contacts or yarns,
/// which refer to grains by row.
io::Snapshot in_spatial_order(io::Snapshot state);

}  // namespace soilweave::packing
