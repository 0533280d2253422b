// The space between grains: power (radical Voronoi) cells and Delaunay tetrahedra, by CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two tessellations of the centres divide space among grains and pores.
//
// The power cell of grain i holds the points whose power |x - x_i|^2 - r_i^2 is least for i. Its faces are planes
// normal to the branches. Between two touching grains the face passes through their contact. Each point belongs to one
// grain, and volumes add up: local void ratios and stresses are averages over cells.
//
// Delaunay tetrahedra join neighbouring centres, with no other centre in their circumscribed sphere. The displacements
// of four centres give one deformation gradient. Their total volume measures an assembly without a cell, such as a bag.
// It gives the thesis's void ratio of a bag (section 3.2.3):
//
//   e = V_tetrahedra / V_grains - 1
//
// A periodic cell gets a margin of images, and each cell or tetrahedron is kept once. The margin grows until they fill
// the cell to 1e-10, so no grain is lost or counted twice.
//
//   const std::vector<double> cells = power_cell_volumes(state);        // m3 per grain
//   const std::vector<Simplex> tetrahedra = delaunay(state);
#pragma once

#include <array>
#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// Returns whether the cell is periodic along every axis.
bool is_periodic(const io::Snapshot& state);

/// Returns the volume of each power cell, m3 (2D: area, m2). A fully periodic cell may be sheared. In an open assembly
/// (3D only), the cells of geotextile nodes bound the soil. Nodes have volume 0 there, and so have grains whose cell
/// reaches outside. Throws DataError if only some axes are periodic. Throws PhysicsError if a grain lacks a cell, or if
/// the cells do not fill a periodic cell to 1e-10.
std::vector<double> power_cell_volumes(const io::Snapshot& state);

/// A tetrahedron of grain centres; in 2D a triangle, without fourth vertex.
struct Simplex {
  /// A grain and its image. The vertex is at position + cell * image.
  struct Vertex {
    std::size_t grain = 0;
    Vec3i image = Vec3i::Zero();
  };
  std::array<Vertex, 4> vertices;
  /// Volume, m3 (2D: m2).
  double volume = 0;
};

/// Returns the Delaunay tetrahedra of the centres, once each. Throws PhysicsError unless they fill a fully periodic
/// cell to 1e-10.
std::vector<Simplex> delaunay(const io::Snapshot& state);

/// Returns the volume of all tetrahedra, m3 (2D: m2).
double delaunay_volume(const io::Snapshot& state);

}  // namespace soilweave::analysis
