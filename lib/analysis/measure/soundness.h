// Limits beyond which a packing or a compressed state is doubted.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/tensor.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Limits beyond which a packing at rest under an isotropic pressure is doubted.
struct SoundLimits {
  /// Largest share of rattlers.
  double rattlers;
  /// Least coordination number 2 Nc/N.
  double coordination;
  /// Largest q/p.
  double obliquity;
  /// Least width of the cell, in diameters of the largest grain.
  double cell;
};
/// Limits of a newly generated packing. The studies' packings of 1000 grains have 14 % rattlers, 4.2 contacts per
/// grain, a cell of 4.8 diameters and q/p = 0.08.
inline constexpr SoundLimits made_packing{0.3, 3, 0.25, 3};
/// Returns the limits of a state in a run. Six packings of the thesis (1000 grains, 4.8 diameters) have 10 to 15 %
/// rattlers at 1 kPa; five have q/p below 0.1. In isostatic packings 2 Nc/N is about the dimension.
constexpr SoundLimits loaded_packing(int dimension) { return {0.25, static_cast<double>(dimension), 0.1, 4}; }

/// Returns the share of rattlers among the grains.
double rattler_share(const io::Snapshot& state, std::size_t rattlers);
/// Returns q/p of the cell; infinite without a mean stress above zero.
double stress_obliquity(const io::Snapshot& state);
/// Returns the cell's widths between opposite faces, in diameters of the largest grain.
Vec3 cell_over_grain(const io::Snapshot& state);

}  // namespace soilweave::analysis
