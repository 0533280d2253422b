// Pictures of a two-scale run: deformed mesh and geosynthetic.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "display/vtk.h"
#include "files/files.h"

namespace soilweave::io {

/// Returns one picture of the mesh per output. Point data: columns of "nodes". Cell data: columns of "points", averaged
/// over an element. Throws DataError if the tables do not fit.
std::vector<VtkPicture> show_mesh(const MultiscaleFile& run);

/// Returns one picture of the bars per output, with the columns of "bars". Empty without a geosynthetic.
std::vector<VtkPicture> show_bars(const MultiscaleFile& run);

}  // namespace soilweave::io
