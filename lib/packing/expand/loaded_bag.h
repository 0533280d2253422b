// The bag that a run loads: its size, geotextile and plates, from plan, scenario and first state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/tables/loading.h"
#include "files/files.h"

namespace soilweave::packing {

/// Returns the bag between two plates that the run loads. Its size follows from the filter-expand plan in the run's
/// history. The area and height of a pillow, cushion or box come from its faces, those of another container from the
/// box around its nodes. The plates are "top" and "bottom", or named by the stages of path "uniaxial". Throws DataError
/// naming `where` and what the run lacks: a series, a geotextile around a container, that plan, or a plate.
analysis::LoadedBag loaded_bag(const io::RunFile& run, const std::string& where);

}  // namespace soilweave::packing
