// Soil reinforced by geotextile as one: its stress and void ratio, those of the fill around it, friction at its faces,
// its yarns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analysis/parts.h"
#include "io/records.h"

namespace soilweave::analysis {

/// Whether the table of the bag can tell anything: of a geotextile, or of soil within fill.
bool is_reinforced(const io::Snapshot& state);
/// The state with the contacts of the reinforced soil: with itself and, unless alone, with nodes, planes and fill.
io::Snapshot soil_contacts(const io::Snapshot& state, bool alone = false);

/// Mean over the whole yarns of a family.
struct YarnMean {
  double tension = 0, strain = 0;  // N, 1
  std::size_t whole = 0, broken = 0;
};
/// By family as in files: faces, sides in plane, sides from face to face.
std::array<YarnMean, 3> yarn_means(const io::Snapshot& state);

/// The soil in the tetrahedra of its centres, as the thesis tells its void ratio (section 3.2.3); without soil,
/// nothing. Through a periodic face there are no tetrahedra: those of reinforced soil end where it ends.
struct DelaunayFill {
  double volume = 0, solids = 0;  // m3
  double void_ratio() const { return solids > 0 ? volume / solids - 1 : 0; }
};
DelaunayFill delaunay_fill(const io::Snapshot& state, const std::vector<bool>& left_out);

/// The room of a bag's grains in both ways, found side by side where there are two threads.
struct BagRoom {
  std::vector<double> cells;  // m3, power cells, as power_cell_volumes has them
  DelaunayFill soil;
};
BagRoom bag_room(const io::Snapshot& state, const std::vector<bool>& left_out, int threads);

/// One row: volume, void ratio and stress of the reinforced soil over its power cells, its Delaunay void ratio,
/// friction mobilised at the faces (thesis Eq. 3.5, from the stress in the quarter x, y > 0; in a periodic cell the
/// middle of the geotextile is the origin), coordination number, yarns by family, broken ones. In a periodic cell also
/// the yarns' part of its stress, and where there is fill its stress, void ratio and coordination number, and p and q
/// of the groups of reinforced soil (volume_of_interest.h).
void put_bag(io::Series& table, const io::Snapshot& state, int threads = 1);
/// One row a yarn: its family, middle and length (m), direction, tension (N), strain, whether it is broken, how near
/// the seam of its face or side it is.
void put_yarns(io::Series& table, const io::Snapshot& state);
/// One row a broken yarn, in the order they broke: when and where.
void put_broken(io::Series& table, const io::Snapshot& state);

}  // namespace soilweave::analysis
