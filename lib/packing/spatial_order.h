// Neighbours in space as neighbours in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/records.h"

namespace soilweave::packing {

/// The same grains in order along a Hilbert curve through their cell, each with its identity: what touches then lies
/// close together in memory, too. Packings that a cache holds anyway, of one chunk (dem/contacts.h), and such that
/// contacts or yarns already name the rows of, come back as they are.
io::Snapshot in_spatial_order(io::Snapshot state);

}  // namespace soilweave::packing
