// The bag that a run loads: size, geotextile and plates.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/loading.h"
#include "files/files.h"

namespace soilweave::packing {

/// Returns the bag between two plates. Its size follows from the filter-expand plan in the run's history: from the
/// faces of a pillow, cushion or box, else from the box around the nodes. The plates are "top" and "bottom", or named
/// by the stages of path "uniaxial". Throws DataError naming `where` and the missing data.
analysis::LoadedBag loaded_bag(const io::RunFile& run, const std::string& where);

}  // namespace soilweave::packing
