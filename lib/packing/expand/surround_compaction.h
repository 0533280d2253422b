// Compaction of loose fill around reinforced soil.
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
  /// Void ratio of all spheres.
  double void_ratio = 0;
  /// Mean distance of the geotextiles' upper and lower faces, m.
  double height = 0;
  /// Mean length of the faces' yarns, end to end, over their rest length.
  double yarn_length = 1;
  /// Void ratio of the reinforced soil, by tetrahedra of its centres; 0 without soil.
  double soil_void_ratio = 0;
  /// Mean stress of the fill over its power cells, Pa.
  double fill_stress = 0;
  /// Mean stress of the reinforced soil, Pa.
  double soil_stress = 0;
  /// 2 Nc/N of the fill.
  double fill_coordination = 0;

  /// Returns one line for progress.
  std::string text() const;
};
/// Measures a cell. fill: whether each body is fill. Stresses need a periodic cell.
Shape shape(const io::Snapshot& state, const std::vector<bool>& fill);

/// Result of compacting a cell.
struct CompactedCell {
  /// The cell at rest.
  Result result;
  /// Measurements as placed and at rest.
  Shape before, after;
  /// One doubt per missed criterion, with its value and the remedy.
  std::vector<Doubt> missed;
};

/// Returns two rows: the cell as placed, and at rest.
io::Series table(const CompactedCell& cell);

/// Compacts the cell slowly at low friction of the fill (Recipe::first_friction), so that the fill moves and not the
/// reinforced part. The rates by axis make all fill equally dense. Then the fill's friction is lowered and restored
/// until the void ratio holds. Throws what compact() throws.
CompactedCell compact_around(const Surrounded& cell, const Surround& how, const dem::Model& model,
                             const dem::Numerics& numerics, const ProgressReport& report,
                             const dem::Safekeeping& safekeeping);

}  // namespace soilweave::packing
