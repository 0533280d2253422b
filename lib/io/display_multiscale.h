// What to show of a run of two scales: the mesh where it is, with what its nodes and points bear, and the geosynthetic.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/files.h"
#include "io/vtk.h"

namespace soilweave::io {

/// One picture an output: elements as triangles or quads (of the corners). Point data: the columns of "nodes"; cell
/// data: those of "points", averaged over the points of the element. Throws DataError where the tables do not fit.
std::vector<VtkPicture> show_mesh(const MultiscaleFile& run);

/// One picture an output: bars as lines; cell data: the columns of "bars". Empty without a geosynthetic.
std::vector<VtkPicture> show_bars(const MultiscaleFile& run);

}  // namespace soilweave::io
