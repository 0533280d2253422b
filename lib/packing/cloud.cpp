// A random cloud of grains without contacts in a periodic cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "core/error.h"
#include "dem/bodies.h"
#include "packing/spatial_order.h"

namespace soilweave::packing {
namespace {

constexpr int most_tries = 200'000;

// Grains already placed, in bins one largest diameter wide, so that a try looks at 27 bins (9 in 2D).
class Placed {
 public:
  Placed(const Vec3& size, double largest_diameter, int dimension) : size_(size), dimension_(dimension) {
    for (int a = 0; a < 3; ++a)
      bins_[a] = a < dimension ? std::clamp(static_cast<int>(std::floor(size[a] / largest_diameter)), 1, 128) : 1;
    members_.resize(static_cast<std::size_t>(bins_.prod()));
  }

  bool fits(const Vec3& at, double radius) const {
    const Vec3i home = bin(at);
    // Fewer than three bins along an axis: every neighbour offset would visit a bin twice.
    const Vec3i reach = (bins_.array() >= 3).select(Vec3i::Ones().array(), bins_.array() - 1).min(1);
    for (int dz = -reach[2]; dz <= reach[2]; ++dz)
      for (int dy = -reach[1]; dy <= reach[1]; ++dy)
        for (int dx = -reach[0]; dx <= reach[0]; ++dx)
          for (const auto& [where, r] : members_[index(home + Vec3i(dx, dy, dz))]) {
            Vec3 d = at - where;
            for (int a = 0; a < dimension_; ++a) d[a] -= size_[a] * std::round(d[a] / size_[a]);
            if (d.squaredNorm() < (radius + r) * (radius + r)) return false;
          }
    return true;
  }
  void add(const Vec3& at, double radius) { members_[index(bin(at))].emplace_back(at, radius); }

 private:
  Vec3i bin(const Vec3& at) const {
    Vec3i b = Vec3i::Zero();
    for (int a = 0; a < dimension_; ++a) b[a] = std::min(static_cast<int>(at[a] / size_[a] * bins_[a]), bins_[a] - 1);
    return b;
  }
  std::size_t index(const Vec3i& b) const {
    Vec3i folded;
    for (int a = 0; a < 3; ++a) folded[a] = (b[a] + bins_[a]) % bins_[a];
    return static_cast<std::size_t>((folded[2] * bins_[1] + folded[1]) * bins_[0] + folded[0]);
  }

  Vec3 size_;
  int dimension_;
  Vec3i bins_;
  std::vector<std::vector<std::pair<Vec3, double>>> members_;
};

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
