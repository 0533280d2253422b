// Boxes, copies, and averages over them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/volume_of_interest.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "analysis/measure/parts.h"
#include "dem/state/bodies.h"

namespace soilweave::analysis {
namespace {

/// Places of grains in the cell. A position stays as it is along axes that are not periodic.
class Wrapping {
 public:
  explicit Wrapping(const io::Snapshot& state) : state_(state), inverse_(state.cell.matrix.inverse()) {}
  Vec3 place(std::size_t grain) const {
    Vec3 reduced = inverse_ * state_.grains.position[grain];
    for (int a = 0; a < state_.grains.dimension; ++a)
      if (state_.cell.periodic[static_cast<std::size_t>(a)]) reduced[a] -= std::floor(reduced[a]);
    return state_.cell.matrix * reduced;
  }

 private:
  const io::Snapshot& state_;
  Mat3 inverse_;
};

}  // namespace

Volume box(const io::Snapshot& state, const Vec3& low, const Vec3& high) {
  Volume volume{
      fmt::format("box {:g} {:g} {:g} {:g} {:g} {:g}", low.x(), high.x(), low.y(), high.y(), low.z(), high.z()),
      {},
      true};
  const Wrapping wrapping(state);
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const Vec3 at = wrapping.place(i);
    bool inside = true;
    for (int a = 0; a < state.grains.dimension; ++a) inside = inside && at[a] >= low[a] && at[a] < high[a];
    if (inside) volume.grains.push_back(i);
  }
  return volume;
}

std::vector<Volume> copies(const io::Snapshot& state) {
  std::map<std::int32_t, Volume> by_copy;
  const std::vector<Part> part = parts(state);
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    if (part[i] != Part::soil || state.grains.copy_id[i] < 0) continue;
    Volume& v = by_copy[state.grains.copy_id[i]];
    v.name = fmt::format("copy {}", state.grains.copy_id[i]);
    v.grains.push_back(i);
  }
  std::vector<Volume> all;
  for (auto& [id, v] : by_copy) all.push_back(std::move(v));
  return all;
}

std::vector<Volume> groups(const io::Snapshot& state) {
  std::int32_t last = 0;
  for (const std::int32_t id : state.grains.copy_id) last = std::max(last, id);
  const auto n = static_cast<std::int32_t>(std::lround(std::sqrt(last + 1.0)));
  if (n < 2) return {};
  const std::int32_t wide = n % 2 == 0 ? 2 : 1;
  std::vector<Volume> all(static_cast<std::size_t>(n / wide));
  for (std::size_t k = 0; k < all.size(); ++k) all[k].name = fmt::format("#{}", k + 1);
  const std::int32_t middle = (n - 1) / 2;
  const std::vector<Part> part = parts(state);
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const std::int32_t id = state.grains.copy_id[i], x = id % n, y = id / n;
    if (part[i] == Part::soil && id >= 0 && (y == middle || y == n / 2))
      all[static_cast<std::size_t>(x / wide)].grains.push_back(i);
  }
  std::erase_if(all, [](const Volume& v) { return v.grains.empty(); });
  return all;
}

Volume whole(const io::Snapshot& state) {
  Volume all{"all grains", std::vector<std::size_t>(state.grains.size())};
  std::iota(all.grains.begin(), all.grains.end(), std::size_t{0});
  return all;
}

Vec3 centre(const io::Snapshot& state, const Volume& volume) {
  const Wrapping wrapping(state);
  Vec3 sum = Vec3::Zero();
  for (const std::size_t i : volume.grains) sum += volume.wrapped ? wrapping.place(i) : state.grains.position[i];
  return sum / static_cast<double>(volume.grains.size());
}

VolumeState volume_state(const io::Snapshot& state, const Volume& volume, const std::vector<Mat3>& dyads,
                         const std::vector<double>& cell_volumes) {
  VolumeState v;
  double solids = 0;
  for (const std::size_t i : volume.grains) {
    if (cell_volumes[i] == 0) continue;  // its cell reaches outside
    v.volume += cell_volumes[i];
    v.stress += dyads[i];
    solids += dem::grain_volume(state.grains.dimension, state.grains.radius[i]);
  }
  if (v.volume > 0) v.stress /= v.volume;
  v.void_ratio = solids > 0 ? v.volume / solids - 1 : 0;
  return v;
}

double cell_volume(const io::Snapshot& state) {
  const int d = state.grains.dimension;
  return state.cell.matrix.topLeftCorner(d, d).determinant();
}

double void_ratio(const io::Snapshot& state) {
  double solids = 0;
  for (const double r : state.grains.radius) solids += dem::grain_volume(state.grains.dimension, r);
  return cell_volume(state) / solids - 1;
}

}  // namespace soilweave::analysis
