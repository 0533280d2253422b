// Limits beyond which a packing, or a state that a run compressed, is doubted.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/tensor.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Limits beyond which a packing at rest under an isotropic pressure is doubted.
struct SoundLimits {
  double rattlers;      // largest share of grains that bear nothing
  double coordination;  // least 2 Nc/N
  double obliquity;     // largest q/p
  double cell;          // narrowest cell, in diameters of its largest grain
};
/// Limits of a packing that was just made. The packings of the studies, 1000 grains of Toyoura sand at rest, have 14 %
/// rattlers, 4.2 contacts per grain, a cell of 4.8 largest grains and a q/p of 0.08, all in shear stresses, which no
/// servo controls.
inline constexpr SoundLimits made_packing{0.3, 3, 0.25, 3};
/// Returns the limits of a state in a run, which measures it. Six packings of 1000 grains of the thesis are 4.8 wide
/// and agree within their scatter. They have 10 to 15 % rattlers at 1 kPa, and five of them a q/p below 0.1: an upright
/// cell cannot relieve shear stress. In isostatic packings 2 Nc/N is about the dimension.
constexpr SoundLimits loaded_packing(int dimension) { return {0.25, static_cast<double>(dimension), 0.1, 4}; }

/// Returns the share of grains outside the backbone (Coordination::rattlers).
double rattler_share(const io::Snapshot& state, std::size_t rattlers);
/// Returns q/p of the whole cell; infinite without a mean stress above zero.
double stress_obliquity(const io::Snapshot& state);
/// Returns the distances of opposite faces over the diameter of the largest grain, along the cell's axes.
Vec3 cell_over_grain(const io::Snapshot& state);

}  // namespace soilweave::analysis
