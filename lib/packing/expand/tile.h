// Copies of a representative volume, and the part inside a container.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "files/records.h"

namespace soilweave::packing {

/// Returns copies of a periodic packing in a block around the origin. Contacts through faces join neighbouring copies,
/// with their whole history. Contacts through the outside are lost, except along the axes of `closed`: there the cell
/// stays periodic. copy_id: number of the copy, x fastest. Throws DataError if the packing is aperiodic.
io::Snapshot tile(const io::Snapshot& packing, const std::array<int, 3>& copies,
                  const std::array<bool, 3>& closed = {false, false, false});

/// Returns the grains for which keep(index) holds, and their contacts, without planes.
io::Snapshot filter(const io::Snapshot& state, const std::function<bool(std::size_t)>& keep);

}  // namespace soilweave::packing
