// Clouds of grains that do not touch, to compact.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "packing/generate/cloud.h"
#include "packing/generate/grading.h"
#include "packing/generate/standard.h"

namespace soilweave::support {

/// Returns that many grains of Toyoura sand in a cube, apart, at this void ratio.
inline io::Snapshot sparse(std::size_t grains, double void_ratio = 2.0) {
  const packing::Room room{packing::Grading::toyoura(), 3, {1, 1, 1}, void_ratio};
  return packing::cloud(packing::grain_radii(room, grains, packing::GrainSize{true, {}}), void_ratio, {1, 1, 1}, 3,
                        2650e3, 3);
}

}  // namespace soilweave::support
