// Numbers that are compared with the limits of a sound packing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/soundness.h"

#include <algorithm>
#include <limits>

#include "analysis/measure/stress.h"
#include "dem/state/cell.h"

namespace soilweave::analysis {

double rattler_share(const io::Snapshot& state, std::size_t rattlers) {
  return static_cast<double>(rattlers) / static_cast<double>(state.grains.size());
}

double stress_obliquity(const io::Snapshot& state) {
  const int dimension = state.grains.dimension;
  const Mat3 stress = cell_stress(state);
  const double p = mean(stress, dimension);
  return p > 0 ? deviatoric_stress(stress, dimension) / p : std::numeric_limits<double>::infinity();
}

Vec3 cell_over_grain(const io::Snapshot& state) {
  const double largest = 2 * *std::max_element(state.grains.radius.begin(), state.grains.radius.end());
  return dem::Cell(state.cell, state.grains.dimension).widths() / largest;
}

}  // namespace soilweave::analysis
