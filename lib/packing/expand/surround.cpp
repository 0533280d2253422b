// Reinforced soil in a periodic cell, with soil put around it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/surround.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "analysis/measure/tessellation.h"
#include "analysis/tables/bag.h"
#include "core/error.h"
#include "dem/state/bodies.h"
#include "files/files.h"
#include "packing/expand/reinforced.h"
#include "packing/expand/tile.h"
#include "packing/generate/placed.h"
#include "packing/generate/spatial_order.h"

namespace soilweave::packing {
namespace {

// Additions to the requested void ratio at which the fill is placed: the first, the increment while the fill finds no
// room, and the last.
constexpr double first_looseness = 0.35, next_looseness = 0.15, last_looseness = 5;
constexpr int most_tries_of_a_grain = 10'000;
// Least possible void ratio of fill with a narrow grading.
constexpr double densest = 0.35;

double solids(const io::GrainsRecord& g) {
  return std::accumulate(g.radius.begin(), g.radius.end(), 0.0,
                         [](double sum, double r) { return sum + dem::grain_volume(3, r); });
}

// Returns the copies that the user gives, or as many as cover the reinforced part.
std::array<int, 3> copies_around(const Surround& how, const io::Snapshot& volume, const Vec3& size) {
  if (how.copies) return *how.copies;
  std::array<int, 3> n{};
  for (int a = 0; a < 3; ++a) {
    const double length = volume.cell.matrix(a, a);
    if (length > 2 * size[a])
      throw DataError(fmt::format(
          "surround.representative_volume: a copy is {:.4g} m long along {}, more than twice the reinforced part of "
          "{:.4g} m: give a smaller surround.scale, or surround.copies to have so much soil around it",
          length, "xyz"[a], size[a]));
    n[static_cast<std::size_t>(a)] = static_cast<int>(std::ceil(size[a] / length * (1 - 1e-9)));
  }
  return n;
}

// Returns the block of the copies that the user gives, or else the block that the soil was cut from. Tries the copies
// that cover the soil, then up to two copies less along each axis. If none fits, returns the covering block.
io::Snapshot block_of(const io::Snapshot& reinforced, const Surround& how, const io::Snapshot& volume,
                      std::array<int, 3>& copies) {
  copies = copies_around(how, volume, extent(reinforced));
  io::Snapshot block = tile(volume, copies);
  if (how.copies || is_cut_from(reinforced, block)) return block;
  for (int k = 0; k < 27; ++k) {
    const std::array<int, 3> other = {copies[0] - k % 3, copies[1] - k / 3 % 3, copies[2] - k / 9};
    if (*std::min_element(other.begin(), other.end()) < 1) continue;
    io::Snapshot smaller = tile(volume, other);
    if (!is_cut_from(reinforced, smaller)) continue;
    copies = other;
    return smaller;
  }
  return block;
}

void demand_cover(const io::Snapshot& block, const io::Snapshot& part) {
  for (int a = 0; a < 3; ++a) {
    double reach = 0;
    for (const Vec3& x : part.grains.position) reach = std::max(reach, std::abs(x[a]));
    const double half = 0.5 * block.cell.matrix(a, a);
    if (half + *std::max_element(block.grains.radius.begin(), block.grains.radius.end()) < reach)
      throw DataError(
          fmt::format("the copies of surround.representative_volume reach to {} = {:.4g} m, the reinforced part to "
                      "{:.4g} m: raise surround.copies or surround.scale",
                      "xyz"[a], half, reach));
  }
}

// Returns the lengths of the cell. Each is the length of the block plus a margin, and at least `least`. The margin is
// equal along all axes and gives the cell its volume.
Vec3 lengths(const Vec3& block, const Vec3& least, double volume) {
  const auto at = [&](double margin) -> Vec3 { return (block.array() + margin).max(least.array()).matrix(); };
  double low = -block.minCoeff(), high = block.maxCoeff();
  while (at(high).prod() < volume) high *= 2;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (at(middle).prod() < volume ? low : high) = middle;
  }
  return at(high);
}

// Returns the volume that the reinforced part takes, m3.
double taken_by(const io::Snapshot& part) {
  io::Snapshot open = part;
  open.cell.periodic = {false, false, false};
  return analysis::delaunay_volume(open);
}

// Returns the lengths of a loose cell that has the volume and becomes `dense` by compression. The spaces above the part
// (`height` high) and beside the part shrink by one factor. So uniformly loose fill becomes uniformly dense.
Vec3 loose_lengths(const Vec3& dense, double height, double taken, double volume) {
  const double opened = (volume - taken) / (dense.prod() - taken);
  const double z = height + (dense.z() - height) * opened;
  const double wider = 0.5 * (std::sqrt(std::pow(dense.x() - dense.y(), 2) + 4 * volume / z) - dense.x() - dense.y());
  return {dense.x() + wider, dense.y() + wider, z};
}

// Refuses a void ratio that is too small for the content of the cell, before anything is placed.
void demand_room(const io::Snapshot& part, double e, double all_solids) {
  const Vec3 size = extent(part);
  const double volume = (1 + e) * all_solids;
  if (size.prod() >= volume)
    throw DataError(
        fmt::format("the reinforced part, {:.4g} x {:.4g} x {:.4g} m, is higher or wider than the cell of {:.4g} m3 "
                    "that it and its "
                    "fill make at surround.void_ratio {:.4g}: raise surround.void_ratio, or give more surround.copies",
                    size.x(), size.y(), size.z(), volume, e));
  const double taken = taken_by(part), fill = all_solids - solids(part.grains);
  if (volume - taken >= (1 + densest) * fill) return;
  throw DataError(fmt::format(
      "the fill has no room: at surround.void_ratio {:.4g} the cell leaves {:.3g} m3 around the reinforced part for "
      "{:.3g} m3 of grains: ask for a void ratio of more than {:.3f}, or give fewer surround.copies",
      e, std::max(0.0, volume - taken), fill, (taken + (1 + densest) * fill) / all_solids - 1));
}

// Places the fill at random in the space around the reinforced part. Then the fill is as dense beside the part as above
// it, and bears the pressure on all sides. At its places in the block, most fill would lie above the part.
class Placing {
 public:
  Placing(const io::Snapshot& part, const Vec3& size, double largest)
      : size_(size), inside_(part), placed_(size, 2 * largest, 3) {
    for (std::size_t i = 0; i < part.grains.size(); ++i)
      placed_.add(home(part.grains.position[i]), part.grains.radius[i]);
  }

  // Returns a place for a grain; none after many tries.
  std::optional<Vec3> find(double radius) {
    for (int k = 0; k < most_tries_of_a_grain; ++k) {
      Vec3 at;
      for (int a = 0; a < 3; ++a) at[a] = (uniform() - 0.5) * size_[a];
      if (!placed_.fits(home(at), radius) || inside_(at)) continue;
      placed_.add(home(at), radius);
      return at;
    }
    return std::nullopt;
  }

 private:
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  // Returns the point moved into the cell that begins at the origin.
  Vec3 home(const Vec3& at) const {
    Vec3 x = at;
    for (int a = 0; a < 3; ++a) {
      x[a] -= size_[a] * std::floor(x[a] / size_[a]);
      if (x[a] >= size_[a]) x[a] = 0;
    }
    return x;
  }

  Vec3 size_;
  Inside inside_;
  Placed placed_;
  std::mt19937_64 engine_{1};
};

void scale_volume(io::Snapshot& volume, double factor) {
  volume.cell.matrix *= factor;
  for (Vec3& x : volume.grains.position) x *= factor;
  for (double& r : volume.grains.radius) r *= factor;
  for (double& m : volume.grains.mass) m *= factor * factor * factor;
  volume.contacts = {};
}

io::Snapshot part_of(const io::Snapshot& file, const io::Snapshot& block, const Surround& how,
                     const std::array<int, 3>& copies) {
  if (how.form == Surround::Form::wrapped) {
    io::Snapshot part = file;
    part.planes = {};
    return part;
  }
  const bool cut = is_cut_from(file, block);
  std::vector<bool> keep(file.grains.size(), false);
  for (std::size_t i = 0; i < keep.size(); ++i) {
    const std::int64_t id = file.grains.body_id[i];
    const bool known = cut && id >= 0 && static_cast<std::size_t>(id) < block.grains.size();
    const Vec3& x = known ? block.grains.position[static_cast<std::size_t>(id)] : file.grains.position[i];
    keep[i] = true;
    for (int a = 0; a < 2; ++a) {
      const double half = 0.5 * block.cell.matrix(a, a);
      keep[i] = keep[i] && std::abs(x[a]) <= half * (1 - 2 * how.rings / copies[static_cast<std::size_t>(a)]);
    }
  }
  return between_faces(file, keep);
}

// Adds a grain of the block as fill.
void add_fill(const io::GrainsRecord& from, std::size_t k, const Surround& how, double density, io::GrainsRecord& to,
              std::int64_t id) {
  to.body_id.push_back(id);
  to.position.push_back(from.position[k]);
  to.orientation.emplace_back(1, 0, 0, 0);
  to.velocity.emplace_back(Vec3::Zero()), to.angular_velocity.emplace_back(Vec3::Zero());
  to.radius.push_back(from.radius[k]);
  to.mass.push_back(density > 0 ? density * dem::grain_volume(3, from.radius[k]) : from.mass[k]);
  to.material_id.push_back(how.material);
  to.copy_id.push_back(-1);
}

}  // namespace

Surrounded surround(const io::Snapshot& reinforced, const Surround& how, double density) {
  if (reinforced.yarns.size() == 0)
    throw DataError("the file to surround has no geotextile: give a bag or sheets that filter-expand made");
  for (const bool periodic : reinforced.cell.periodic)
    if (periodic) throw DataError("the file to surround lies in a periodic cell: give it as filter-expand made it");
  const std::vector<std::int32_t>& materials = reinforced.grains.material_id;
  if (std::find(materials.begin(), materials.end(), how.material) != materials.end())
    throw DataError(
        fmt::format("surround.material {} is one that the file's grains have: give the fill a [[material]] of "
                    "its own, so that its friction alone is lowered",
                    how.material));
  io::Snapshot volume = how.volume;
  scale_volume(volume, how.scale);
  std::array<int, 3> copies{};
  const io::Snapshot block = block_of(reinforced, how, volume, copies);
  demand_cover(block, reinforced);
  Surrounded result;
  result.state = part_of(reinforced, block, how, copies);
  const Origin from = origin(result.state, block);
  result.cut_away = from.cut;
  io::Snapshot& state = result.state;
  const io::Snapshot part = state;
  std::int64_t id = 1 + *std::max_element(part.grains.body_id.begin(), part.grains.body_id.end());
  for (std::size_t k = 0; k < from.taken.size(); ++k)
    if (!from.taken[k]) add_fill(block.grains, k, how, density, state.grains, id++);
  const std::size_t first = part.grains.size(), n = state.grains.size();
  if (n == first) throw DataError("no grain of surround.representative_volume lies outside of the reinforced part");
  result.fill.assign(n, false);
  std::fill(result.fill.begin() + static_cast<std::ptrdiff_t>(first), result.fill.end(), true);

  const double all_solids = solids(state.grains), fill_solids = all_solids - solids(part.grains);
  const double mean = std::cbrt(fill_solids / static_cast<double>(n - first) / dem::grain_volume(3, 1));
  const Vec3 block_size = block.cell.matrix.diagonal();
  const Vec3 least = extent(part) + Vec3::Constant(how.gap.value_or(2 * mean));
  const double e = how.recipe.void_ratio.value_or(0.7);
  if (how.recipe.void_ratio) demand_room(part, e, all_solids);
  // Large grains are placed first, because small ones still find places between them.
  std::vector<std::size_t> order(n - first);
  std::iota(order.begin(), order.end(), first);
  const std::vector<double>& radius = state.grains.radius;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return radius[i] > radius[j]; });
  const Vec3 dense = lengths(block_size, least, (1 + e) * all_solids);
  const double height = extent(part).z(), taken = taken_by(part);
  for (double looser = first_looseness;; looser += next_looseness) {
    if (looser > last_looseness)
      throw DataError(
          fmt::format("{} grains of fill find no place in a cell of void ratio {:.3g} around the reinforced "
                      "part: give finer grains (surround.scale) or fewer surround.copies",
                      order.size(), e + looser));
    const Vec3 size = loose_lengths(dense, height, taken, dense.prod() + looser * all_solids);
    Placing placing(part, size, *std::max_element(radius.begin(), radius.end()));
    const bool all = std::all_of(order.begin(), order.end(), [&](std::size_t i) {
      const std::optional<Vec3> at = placing.find(radius[i]);
      if (at) state.grains.position[i] = *at;
      return at.has_value();
    });
    if (!all) continue;
    state.cell = {};
    state.cell.matrix = size.asDiagonal();
    state = in_spatial_order(std::move(state), first);
    const Vec3 way = size - dense;
    result.shares = way.cwiseQuotient(size) * (size.minCoeff() / way.maxCoeff());
    return result;
  }
}

}  // namespace soilweave::packing
