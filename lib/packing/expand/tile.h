// Copies of a representative volume side by side, and the part of them that lies in a container.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "files/records.h"

namespace soilweave::packing {

/// Returns copies of a periodic packing in a block around the origin. Contacts through faces join neighbouring copies
/// with their whole history. Contacts through the outside of the block are lost, except along an axis of `closed`:
/// there they join the block with itself, and its cell stays periodic. copy_id: number of the copy, x fastest. Throws
/// DataError if the packing is aperiodic.
io::Snapshot tile(const io::Snapshot& packing, const std::array<int, 3>& copies,
                  const std::array<bool, 3>& closed = {false, false, false});

/// Returns the grains for which keep(index) holds, with the contacts among them, without planes.
io::Snapshot filter(const io::Snapshot& state, const std::function<bool(std::size_t)>& keep);

}  // namespace soilweave::packing
