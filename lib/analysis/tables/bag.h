// Soil reinforced by geotextile as a whole: its stress and void ratio, those of the fill around it, friction at its
// faces, its yarns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analysis/measure/parts.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns whether the table of the bag has content: a geotextile, or soil within fill.
bool is_reinforced(const io::Snapshot& state);
/// Returns the state with the contacts of the reinforced soil only: with itself and, unless alone, with nodes, planes
/// and fill.
io::Snapshot soil_contacts(const io::Snapshot& state, bool alone = false);

/// Mean over the unbroken yarns of a family.
struct YarnMean {
  double tension = 0, strain = 0;  // N, 1
  std::size_t whole = 0, broken = 0;
};
/// Returns means by family, numbered as in files: faces; sides in plane; sides from face to face.
std::array<YarnMean, 3> yarn_means(const io::Snapshot& state);

/// The soil in the tetrahedra of its centres (thesis section 3.2.3); zeros without soil. No tetrahedron passes a
/// periodic face.
struct DelaunayFill {
  double volume = 0, solids = 0;  // m3
  /// Returns e = V_tetrahedra / V_grains - 1; 0 without soil.
  double void_ratio() const { return solids > 0 ? volume / solids - 1 : 0; }
};
/// Measures the tetrahedra between all centres that are not left out.
DelaunayFill delaunay_fill(const io::Snapshot& state, const std::vector<bool>& left_out);

/// Volumes of a bag's grains by both tessellations, computed in parallel if there are two threads.
struct BagRoom {
  std::vector<double> cells;  // power cells as in power_cell_volumes, m3
  DelaunayFill soil;
};
/// Measures both, with left_out as for delaunay_fill().
BagRoom bag_room(const io::Snapshot& state, const std::vector<bool>& left_out, int threads);

/// Appends one row: volume, void ratio and stress of the reinforced soil over its power cells, its Delaunay void ratio,
/// mobilised friction at the faces (thesis Eq. 3.5, from the stress in the quarter x, y > 0; in a periodic cell the
/// middle of the geotextile is the origin), coordination number, yarns by family, broken yarns. In a periodic cell the
/// row includes the yarns' part of the stress. With fill it includes the fill's stress, void ratio and coordination
/// number, and p and q of the groups of reinforced soil (volume_of_interest.h).
void put_bag(io::Series& table, const io::Snapshot& state, int threads = 1);
/// Appends one row per yarn: family, middle and length (m), direction, tension (N), strain, whether it is broken,
/// nearness to its seam.
void put_yarns(io::Series& table, const io::Snapshot& state);
/// Appends one row per broken yarn, in the order of breaking: time and place.
void put_broken(io::Series& table, const io::Snapshot& state);

}  // namespace soilweave::analysis
