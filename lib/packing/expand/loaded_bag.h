// The bag that a run loads: its size, geotextile and plates, from plan, scenario and first state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/loading.h"
#include "files/files.h"

namespace soilweave::packing {

/// Returns the bag between two plates that the run loads. Its size follows from the filter-expand plan in the run's
/// history: area and height of the faces of a pillow or cushion, of a box, or of the box around the nodes of another
/// container. Throws DataError naming `where` and what the run lacks: a series, a geotextile around a container, that
/// plan, or one of the plates ("top" and "bottom", or those named by its stages of path "uniaxial").
analysis::LoadedBag loaded_bag(const io::RunFile& run, const std::string& where);

}  // namespace soilweave::packing
