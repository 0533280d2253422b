// The space between grains: power (radical Voronoi) cells and Delaunay tetrahedra, by CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where does a grain end and its pore begin to belong to another? Two tessellations of the centres answer.
//
// The power (radical Voronoi) cell of grain i holds the points whose power |x - x_i|^2 - r_i^2 is least for i. Its
// faces are planes normal to the branches; between two grains that touch, the face passes through their contact. So
// every point of the assembly belongs to one grain, and volumes add up: local void ratios and stresses are averages
// over cells.
//
// The Delaunay tetrahedra join the centres of neighbouring grains, four at a time, so that no other centre lies in
// their circumscribed sphere. They show the pores and how they deform: the displacements of four centres give one
// deformation gradient. Their total volume serves as the volume of an assembly without a cell, such as a bag. Over
// the volume of the grains it gives the thesis's void ratio of a bag (section 3.2.3):
//
//   e = V_tetrahedra / V_grains - 1
//
// In a periodic cell, images of the grains are laid in a margin around it, and each cell or tetrahedron is kept once.
// The margin grows until they fill the periodic cell to 1e-10: a grain lost or counted twice is found at once.
//
//   const std::vector<double> cells = power_cell_volumes(state);        // m3 per grain
//   const std::vector<Simplex> tetrahedra = delaunay(state);
#pragma once

#include <array>
#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// Returns the volume of every grain's power cell, m3 (2D: area, m2). A fully periodic cell may be sheared. In an open
/// assembly of spheres the cells of geotextile nodes bound those of the soil. Nodes, and soil whose cell reaches
/// outside, have volume 0. Throws DataError for a cell that is periodic along some axes only; PhysicsError unless every
/// grain has a cell and they fill the periodic cell to 1e-10.
std::vector<double> power_cell_volumes(const io::Snapshot& state);

/// A tetrahedron of grain centres (2D: a triangle, without the fourth vertex). A vertex lies at position + cell *
/// image.
struct Simplex {
  /// A grain, and the image of it that is meant.
  struct Vertex {
    std::size_t grain = 0;
    Vec3i image = Vec3i::Zero();
  };
  std::array<Vertex, 4> vertices;
  double volume = 0;  // m3 (2D: m2)
};

/// Returns the Delaunay tetrahedra of the grain centres. A tetrahedron through periodic faces appears once. With all
/// axes periodic they fill the cell to 1e-10, or PhysicsError is thrown.
std::vector<Simplex> delaunay(const io::Snapshot& state);

/// Returns the volume of all tetrahedra, m3 (2D: m2): the measure of an assembly without a cell (thesis section 3.2.3).
double delaunay_volume(const io::Snapshot& state);

}  // namespace soilweave::analysis
