// The space between grains: power (radical Voronoi) cells and Delaunay tetrahedra, by CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "io/records.h"

namespace soilweave::analysis {

/// Volume of every grain's power cell, m3 (2D: area, m2). A cell that is periodic along every axis may be sheared; images
/// are laid around it and triangulated. Throws DataError for one that is periodic along some axes only, and PhysicsError
/// unless every grain has a cell and they fill the periodic cell to 1e-10: a grain lost or counted twice shows there.
/// In an open assembly of spheres the cells of nodes of geotextiles bound those of the soil; nodes, and soil whose cell
/// reaches outside, have the volume 0.
std::vector<double> power_cell_volumes(const io::Snapshot& state);

/// A tetrahedron of grain centres (2D: a triangle, the fourth vertex unused). A vertex lies at position + cell * image.
struct Simplex {
  struct Vertex {
    std::size_t grain = 0;
    Vec3i image = Vec3i::Zero();
  };
  std::array<Vertex, 4> vertices;
  double volume = 0;  // m3 (2D: m2)
};

/// Delaunay tetrahedra of the grain centres. Through periodic faces each is given once, and together they fill the
/// cell to 1e-10 where all axes are periodic (else PhysicsError).
std::vector<Simplex> delaunay(const io::Snapshot& state);

/// Their total volume, m3 (2D: m2): the measure of an assembly without a cell (thesis, section 3.2.3).
double delaunay_volume(const io::Snapshot& state);

}  // namespace soilweave::analysis
