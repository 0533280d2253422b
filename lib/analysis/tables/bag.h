// Tables of reinforced soil, the fill around it, and its yarns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analysis/measure/parts.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns whether there is a geotextile, or soil within fill.
bool is_reinforced(const io::Snapshot& state);
/// Returns the state with the contacts of reinforced soil only. `alone` drops contacts with nodes, planes and fill.
io::Snapshot soil_contacts(const io::Snapshot& state, bool alone = false);

/// Means over one family of yarns.
struct YarnMean {
  /// Mean over unbroken yarns: tension in N, strain. NaN if all yarns are broken.
  double tension = 0, strain = 0;
  /// Numbers of yarns.
  std::size_t whole = 0, broken = 0;
};
/// Returns means for faces, sides in plane, and sides from face to face.
std::array<YarnMean, 3> yarn_means(const io::Snapshot& state);

/// Soil in the Delaunay tetrahedra of its centres (thesis section 3.2.3); zeros without soil. No tetrahedron crosses a
/// periodic face.
struct DelaunayFill {
  /// Volumes of tetrahedra and of grains, m3.
  double volume = 0, solids = 0;
  /// Returns volume / solids - 1; 0 without soil.
  double void_ratio() const { return solids > 0 ? volume / solids - 1 : 0; }
};
/// Measures the tetrahedra of the grains that `left_out` does not mark.
DelaunayFill delaunay_fill(const io::Snapshot& state, const std::vector<bool>& left_out);

/// Volumes of a bag's grains by both tessellations.
struct BagRoom {
  /// Power cells as in power_cell_volumes(), m3.
  std::vector<double> cells;
  DelaunayFill soil;
};
/// Measures both tessellations, in parallel if there are two threads.
BagRoom bag_room(const io::Snapshot& state, const std::vector<bool>& left_out, int threads);

/// Appends one row: volume, void ratios, stress, coordination and yarns of the reinforced soil. Mobilised friction at
/// the faces (thesis Eq. 3.5) uses the stress in the quarter x, y > 0. In a periodic cell the quarter counts from the
/// geotextile's middle, and the row also has the yarns' stress. With fill, the row also has the fill's values, and p
/// and q by groups (volume_of_interest.h).
void put_bag(io::Series& table, const io::Snapshot& state, int threads = 1);
/// Appends one row per yarn: family, middle, length (m), direction, tension (N), strain, break, nearness to its seam.
void put_yarns(io::Series& table, const io::Snapshot& state);
/// Appends time and place of each break, in order of breaking.
void put_broken(io::Series& table, const io::Snapshot& state);

}  // namespace soilweave::analysis
