// Copies of a representative volume side by side, and what of them lies in a container.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "io/records.h"

namespace soilweave::packing {

/// Copies of a periodic packing in a block around the origin. Contacts through the faces join neighbouring copies with
/// their whole memory; those through the outside of the block are lost, where an axis of `closed` is true they join the
/// block with itself and the block's cell stays periodic there. copy_id: the copy, x fastest. Throws DataError where the
/// packing is not periodic.
io::Snapshot tile(const io::Snapshot& packing, const std::array<int, 3>& copies,
                  const std::array<bool, 3>& closed = {false, false, false});

/// The grains for which keep(index) holds, with the contacts among them; planes are left out.
io::Snapshot filter(const io::Snapshot& state, const std::function<bool(std::size_t)>& keep);

}  // namespace soilweave::packing
