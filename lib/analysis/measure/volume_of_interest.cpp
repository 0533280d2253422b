// Boxes, copies, and averages over them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/volume_of_interest.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "analysis/measure/parts.h"
#include "dem/state/bodies.h"

namespace soilweave::analysis {
namespace {

// Finds the image of a grain that lies in a box.
class ImageInBox {
 public:
  ImageInBox(const io::Snapshot& state, const Vec3& low, const Vec3& high)
      : state_(state), inverse_(state.cell.matrix.inverse()), low_(low), high_(high) {
    // The image in the cell is tried first, so that a box wider than the cell takes each grain in the cell.
    const auto steps = [&](int axis) {
      return state.cell.periodic[static_cast<std::size_t>(axis)] && axis < state.grains.dimension
                 ? std::vector<int>{0, -1, 1}
                 : std::vector<int>{0};
    };
    for (const int z : steps(2))
      for (const int y : steps(1))
        for (const int x : steps(0)) shifts_.emplace_back(x, y, z);
  }

  // Returns the image in the box, counted from the unwrapped position; none if the box holds no image of the grain.
  // Images in the cell and in the neighbouring cells are tried.
  std::optional<Vec3i> of(std::size_t grain) const {
    const Vec3& position = state_.grains.position[grain];
    const Vec3 reduced = inverse_ * position;
    Vec3i wrap = Vec3i::Zero();
    for (int a = 0; a < state_.grains.dimension; ++a)
      if (state_.cell.periodic[static_cast<std::size_t>(a)]) wrap[a] = -static_cast<int>(std::floor(reduced[a]));
    for (const Vec3i& shift : shifts_) {
      const Vec3i image = wrap + shift;
      if (holds(position + state_.cell.matrix * image.cast<double>())) return image;
    }
    return std::nullopt;
  }

 private:
  bool holds(const Vec3& at) const {
    for (int a = 0; a < state_.grains.dimension; ++a)
      if (at[a] < low_[a] || at[a] >= high_[a]) return false;
    return true;
  }

  const io::Snapshot& state_;
  Mat3 inverse_;
  Vec3 low_, high_;
  std::vector<Vec3i> shifts_;
};

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

double sum_of_distances(const std::vector<double>& values, double from) {
  double sum = 0;
  for (const double x : values) sum += std::abs(x - from);
  return sum;
}

// Largest ratio of two mean distances of grains along x: from the median of their column, and from the median of all.
// For separate columns the ratio is a half (two columns) to a tenth (ten). For mixed columns it is nearly 1. Medians
// tolerate single grains that a torn bag has thrown out.
constexpr double largest_distance = 0.7;

// Returns whether copies, numbered along x first, lie in n columns that follow each other along x.
bool are_columns(std::int32_t n, const io::Snapshot& state, const std::vector<Part>& part) {
  std::vector<std::vector<double>> columns(static_cast<std::size_t>(n));
  std::vector<double> all, medians;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] != Part::soil || state.grains.copy_id[i] < 0) continue;
    all.push_back(state.grains.position[i].x());
    columns[static_cast<std::size_t>(state.grains.copy_id[i] % n)].push_back(all.back());
  }
  std::erase_if(columns, [](const std::vector<double>& column) { return column.empty(); });
  double within = 0;
  for (std::vector<double>& column : columns) {
    medians.push_back(median(column));
    within += sum_of_distances(column, medians.back());
  }
  return std::ranges::is_sorted(medians, std::ranges::less_equal()) && !all.empty() &&
         within < largest_distance * sum_of_distances(all, median(all));
}

// Returns n if the copies are n by n in one layer, numbered along x first; otherwise 0. The greatest copy number does
// not determine n: where sheets cover only the middle of the soil, equally many rows of copies are missing on all four
// sides.
std::int32_t copies_along(const io::Snapshot& state, const std::vector<Part>& part) {
  std::set<std::int32_t> ids;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (part[i] == Part::soil && state.grains.copy_id[i] >= 0) ids.insert(state.grains.copy_id[i]);
  if (ids.empty()) return 0;
  const std::int32_t first = *ids.begin(), last = *ids.rbegin();
  for (std::int32_t n = 2; n <= last; ++n) {
    if (first / n + last / n != n - 1) continue;
    std::set<std::int32_t> columns;
    for (const std::int32_t id : ids) columns.insert(id % n);
    if (*columns.begin() + *columns.rbegin() == n - 1 && are_columns(n, state, part)) return n;
  }
  return 0;
}

}  // namespace

Volume box(const io::Snapshot& state, const Vec3& low, const Vec3& high) {
  Volume volume{"box", {}, {}};
  for (int a = 0; a < state.grains.dimension; ++a) volume.name += fmt::format(" {:g} {:g}", low[a], high[a]);
  const ImageInBox image(state, low, high);
  const std::vector<bool> node = io::nodes(state);
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    if (node[i]) continue;
    if (const std::optional<Vec3i> inside = image.of(i)) {
      volume.grains.push_back(i);
      volume.images.push_back(*inside);
    }
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
  const std::vector<Part> part = parts(state);
  const std::int32_t n = copies_along(state, part);
  if (n == 0) return {};
  const std::int32_t wide = n % 2 == 0 ? 2 : 1;
  std::vector<Volume> all(static_cast<std::size_t>(n / wide));
  for (std::size_t k = 0; k < all.size(); ++k) all[k].name = fmt::format("#{}", k + 1);
  const std::int32_t middle = (n - 1) / 2;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const std::int32_t id = state.grains.copy_id[i], x = id % n, y = id / n;
    if (part[i] == Part::soil && id >= 0 && (y == middle || y == n / 2))
      all[static_cast<std::size_t>(x / wide)].grains.push_back(i);
  }
  std::erase_if(all, [](const Volume& v) { return v.grains.empty(); });
  return all;
}

Volume whole(const io::Snapshot& state) {
  Volume all{"all grains", std::vector<std::size_t>(state.grains.size()), {}};
  std::iota(all.grains.begin(), all.grains.end(), std::size_t{0});
  return all;
}

Vec3 centre(const io::Snapshot& state, const Volume& volume) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < volume.grains.size(); ++k) {
    sum += state.grains.position[volume.grains[k]];
    if (!volume.images.empty()) sum += state.cell.matrix * volume.images[k].cast<double>();
  }
  return sum / static_cast<double>(volume.grains.size());
}

VolumeState volume_state(const io::Snapshot& state, const Volume& volume, const std::vector<Mat3>& dyads,
                         const std::vector<double>& cell_volumes) {
  VolumeState v;
  double solids = 0;
  for (const std::size_t i : volume.grains) {
    if (cell_volumes[i] == 0) continue;  // the cell of this grain reaches outside
    v.grains += 1;
    v.volume += cell_volumes[i];
    v.stress += dyads[i];
    solids += dem::grain_volume(state.grains.dimension, state.grains.radius[i]);
  }
  // Without grains stress and void ratio are 0 / 0, a NaN.
  v.stress /= v.volume;
  v.void_ratio = v.volume / solids - 1;
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
