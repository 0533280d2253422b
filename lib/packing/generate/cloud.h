// A random cloud of grains without contacts in a periodic cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "files/records.h"

namespace soilweave::packing {

/// Returns grains at random places without overlap (random sequential addition). The cell is upright and periodic.
/// radii: m, largest first. density: kg/m3 (2D: per metre of thickness). Large numbers are sorted in space
/// (spatial_order.h). One seed gives one cloud everywhere. Throws DataError if the cell is too small for the largest
/// grain, or too dense for random placing.
io::Snapshot cloud(const std::vector<double>& radii, double void_ratio, const Vec3& proportions, int dimension,
                   double density, std::uint64_t seed);

}  // namespace soilweave::packing
