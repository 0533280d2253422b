// A loose cell around reinforced soil, compacted without harm to it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "dem/keeper.h"
#include "packing/surround.h"

namespace soilweave::packing {

/// Measurements of a cell around reinforced soil.
struct Shape {
  double void_ratio = 0;         // of all spheres
  double height = 0;             // m, between the upper and the lower faces of the geotextiles, by their mean heights
  double yarn_length = 1;        // mean distance of the ends of the faces' yarns, over their rest length
  double soil_void_ratio = 0;    // of the reinforced soil, by the tetrahedra of its centres; 0 without soil
  double fill_stress = 0;        // Pa, mean stress of the fill over its power cells
  double soil_stress = 0;        // Pa, of the reinforced soil
  double fill_coordination = 0;  // 2 Nc/N of the fill

  std::string text() const;
};
/// fill: by body. Stresses need a cell that is periodic.
Shape shape(const io::Snapshot& state, const std::vector<bool>& fill);

struct CompactedCell {
  Result result;
  Shape before, after;
  std::vector<std::string> missed;  // a sentence each: what was missed, by what, and what to change
};

/// A row of the cell as it was placed, and one as it came to rest.
io::Series table(const CompactedCell& cell);

/// Compacts the cell at the pressure, its axes at rates that close all gaps at one speed, while the fill slides
/// (Recipe:: first_friction): slowly, so that the fill moves and not the reinforced part. Then the fill's friction is
/// lowered and restored until the void ratio holds (compact), and what came out is judged. Throws what compact does.
CompactedCell compact_around(const Surrounded& cell, const Surround& how, const dem::Model& model,
                             const dem::Numerics& numerics, const Report& report, const dem::Safekeeping& safekeeping);

}  // namespace soilweave::packing
