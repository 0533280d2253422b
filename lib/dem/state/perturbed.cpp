// A twin of a packing with its grains moved a little at random.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/state/perturbed.h"

#include <random>

namespace soilweave::dem {
namespace {

// Returns a uniform number in [-1, 1) from the engine's bits alone, because standard distributions differ between
// libraries.
double symmetric_uniform(std::mt19937_64& engine) {
  return 2.0 * static_cast<double>(engine() >> 11) * 0x1.0p-53 - 1.0;
}

}  // namespace

io::Snapshot perturbed(const io::Snapshot& packing, double fraction, std::uint64_t seed) {
  io::Snapshot twin = packing;
  std::mt19937_64 engine(seed);
  for (std::size_t i = 0; i < twin.grains.size(); ++i)
    for (int a = 0; a < twin.grains.dimension; ++a)
      twin.grains.position[i][a] += fraction * twin.grains.radius[i] * symmetric_uniform(engine);
  return twin;
}

}  // namespace soilweave::dem
