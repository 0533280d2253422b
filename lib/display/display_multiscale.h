// Pictures of a two-scale run: the deformed mesh with values at its nodes and points, and the geosynthetic.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "display/vtk.h"
#include "files/files.h"

namespace soilweave::io {

/// Returns one picture per output: elements as triangles or quads of their corners. Point data: the columns of "nodes".
/// Cell data: the columns of "points", averaged over the points of the element. Throws DataError if the tables do not
/// fit.
std::vector<VtkPicture> show_mesh(const MultiscaleFile& run);

/// Returns one picture per output: bars as lines with the columns of "bars" as cell data. Empty without a geosynthetic.
std::vector<VtkPicture> show_bars(const MultiscaleFile& run);

}  // namespace soilweave::io
