// Records an output of a two-scale run: tables of nodes, points and bars, a row of the series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fem/model/model.h"
#include "files/files.h"

namespace soilweave::fem {

/// Appends to the tables "elements" (once), "nodes", "points", "bars" and "recorded". Stress and strain are compression
/// positive.
void record(const Model& model, const std::vector<Index>& recorded, io::MultiscaleFile& file);

/// Returns the recorded states of one point as a run, whose series are its rows of the table "points". Throws DataError
/// if the point was not recorded.
io::RunFile run_of_point(const io::MultiscaleFile& file, Index point);

}  // namespace soilweave::fem
