// What a run of two scales writes down at an output: tables of nodes, points and bars, a row of the series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fem/model.h"
#include "io/files.h"

namespace soilweave::fem {

/// The tables "elements" (once), "nodes", "points", "bars" and "recorded". Stress and strain compression positive.
void record(const Model& model, const std::vector<Index>& recorded, io::MultiscaleFile& file);

/// The recorded states of one point as a run: its rows of the table "points" are the series. Throws DataError where the
/// point was not recorded.
io::RunFile run_of_point(const io::MultiscaleFile& file, Index point);

}  // namespace soilweave::fem
