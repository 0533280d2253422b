// Records outputs of a two-scale run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fem/model/model.h"
#include "files/files.h"

namespace soilweave::fem {

/// Appends to tables "elements" (once), "nodes", "points", "bars" and "recorded". Compression is positive.
void record(const Model& model, const std::vector<Index>& recorded, io::MultiscaleFile& file);

/// Returns the recorded states of a point as a run, with its rows of "points" as series. Throws DataError for an
/// unrecorded point.
io::RunFile run_of_point(const io::MultiscaleFile& file, Index point);

}  // namespace soilweave::fem
