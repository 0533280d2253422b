// A loose cell around reinforced soil, compacted without harm to it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/doubts.h"
#include "dem/run/keeper.h"
#include "packing/expand/surround.h"

namespace soilweave::packing {

/// Measurements of a cell around reinforced soil.
struct Shape {
  double void_ratio = 0;         // void ratio of all spheres
  double height = 0;             // distance between the mean heights of the upper and lower faces of the geotextiles, m
  double yarn_length = 1;        // mean distance of the ends of the faces' yarns, over their rest length
  double soil_void_ratio = 0;    // void ratio of the reinforced soil, by the tetrahedra of its centres; 0 without soil
  double fill_stress = 0;        // mean stress of the fill over its power cells, Pa
  double soil_stress = 0;        // mean stress of the reinforced soil, Pa
  double fill_coordination = 0;  // 2 Nc/N of the fill

  /// Returns the measurements in a line, for progress.
  std::string text() const;
};
/// Measures a cell. fill: whether a body is fill. Stresses need a periodic cell.
Shape shape(const io::Snapshot& state, const std::vector<bool>& fill);

/// Result of compacting a cell.
struct CompactedCell {
  Result result;
  Shape before, after;
  std::vector<Doubt> missed;  // one per missed criterion: its value, and what to change
};

/// Returns one row for the cell as placed, and one for it at rest.
io::Series table(const CompactedCell& cell);

/// Compacts the cell at the pressure while the fill slides (Recipe::first_friction), slowly, so that the fill moves and
/// not the reinforced part. The axes' rates make all fill equally dense. Then the fill's friction is lowered and
/// restored until the void ratio holds (compact), and the result is judged. Throws what compact() throws.
CompactedCell compact_around(const Surrounded& cell, const Surround& how, const dem::Model& model,
                             const dem::Numerics& numerics, const ProgressReport& report,
                             const dem::Safekeeping& safekeeping);

}  // namespace soilweave::packing
