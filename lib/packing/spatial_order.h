// Neighbours in space as neighbours in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/records.h"

namespace soilweave::packing {

/// The same grains box by box of their cell, a chunk (dem/contacts.h) a box, each with its identity: what touches then
/// lies close together in memory, too. Packings that a cache holds anyway, of one chunk, and such that contacts or
/// yarns already name the rows of, come back as they are.
io::Snapshot in_spatial_order(io::Snapshot state);

}  // namespace soilweave::packing
