// A random cloud of grains without contacts in a periodic cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "core/error.h"
#include "dem/state/bodies.h"
#include "packing/generate/placed.h"
#include "packing/generate/spatial_order.h"

namespace soilweave::packing {
namespace {

constexpr int most_tries = 200'000;

}  // namespace

io::Snapshot cloud(const std::vector<double>& radii, double void_ratio, const Vec3& proportions, int dimension,
                   double density, std::uint64_t seed) {
  double solids = 0;
  for (const double r : radii) solids += dem::grain_volume(dimension, r);
  const double volume = solids * (1 + void_ratio);
  Vec3 size = Vec3::Ones();
  double shape = 1, narrowest = std::numeric_limits<double>::infinity();
  for (int a = 0; a < dimension; ++a) shape *= proportions[a];
  for (int a = 0; a < dimension; ++a) {
    size[a] = proportions[a] * std::pow(volume / shape, 1.0 / dimension);
    narrowest = std::min(narrowest, size[a]);
  }
  const double largest = 2 * radii.front();
  if (narrowest <= 2 * largest)
    throw DataError(
        fmt::format("{} grains make a cell {:.4g} m wide, and the largest grain is {:.4g} m across: more than half "
                    "the cell; take more grains or a more even cell",
                    radii.size(), narrowest, largest));
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };

  io::Snapshot s;
  s.cell.matrix = size.asDiagonal();
  s.cell.periodic = {true, true, dimension == 3};
  io::GrainsRecord& g = s.grains;
  g.dimension = dimension;
  Placed placed(size, largest, dimension);
  for (const double r : radii) {
    Vec3 at = Vec3::Zero();
    int tries = 0;
    do {
      for (int a = 0; a < dimension; ++a) at[a] = uniform() * size[a];
      if (++tries > most_tries)
        throw DataError(
            fmt::format("grain {} of {} found no place after {} tries at a void ratio of {}: start from a looser "
                        "cloud",
                        g.size() + 1, radii.size(), most_tries, void_ratio));
    } while (!placed.fits(at, r));
    placed.add(at, r);
    g.body_id.push_back(static_cast<std::int64_t>(g.size()));
    g.position.push_back(at);
    g.orientation.emplace_back(1, 0, 0, 0);
    g.velocity.push_back(Vec3::Zero());
    g.angular_velocity.push_back(Vec3::Zero());
    g.radius.push_back(r);
    g.mass.push_back(density * dem::grain_volume(dimension, r));
    g.material_id.push_back(0);
    g.copy_id.push_back(0);
  }
  return in_spatial_order(std::move(s));
}

}  // namespace soilweave::packing
