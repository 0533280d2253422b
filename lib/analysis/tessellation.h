// The space that belongs to each grain: power (radical Voronoi) cells in the periodic, possibly sheared cell, by CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/records.h"

namespace soilweave::analysis {

/// Volume of every grain's power cell, m3 (2D: area, m2). The cell must be periodic along every axis of the space; its
/// images are laid around it and triangulated. Throws PhysicsError unless the cells fill the cell to 1e-9: a grain that
/// was lost or counted twice would show there.
std::vector<double> power_cell_volumes(const io::Snapshot& state);

/// Volume of the Delaunay tetrahedra of the grain centres, m3 (2D: triangles, m2): the measure of an assembly without a
/// cell (thesis §3.2.3).
double delaunay_volume(const io::Snapshot& state);

}  // namespace soilweave::analysis
