// Grains and contacts copied from one record to another, row by row.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "files/records.h"

namespace soilweave::packing {

/// Appends grain i of `from`.
void take_grain(io::GrainsRecord& to, const io::GrainsRecord& from, std::size_t i);
/// Appends contact c of `from` with new numbers of its bodies. `second` below zero is a plane. Reverses a contact of
/// two grains if `second` is less than `first`. `image`: cell offset before this.
void take_contact(io::ContactsRecord& to, const io::ContactsRecord& from, std::size_t c, std::int32_t first,
                  std::int32_t second, const Vec3i& image);
/// Sorts contacts by the numbers of their bodies.
void sort_by_bodies(io::ContactsRecord& contacts);

}  // namespace soilweave::packing
