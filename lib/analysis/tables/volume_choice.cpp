// Copies, groups and boxes by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/volume_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/text/number_word.h"
#include "dem/state/bodies.h"

namespace soilweave::analysis {
namespace {

// Edge of a box over the extent of the state: above the first along every axis, or above the second along any, a box
// has millimetres or centimetres for metres. A box may be far too large along some axes to take everything there.
constexpr double large_edge = 20, largest_edge = 100;

// Returns the extent along each axis, m: that of the cell where it is periodic, because grains are taken into it; else
// that of the grains, without nodes.
Vec3 extents(const io::Snapshot& state) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const std::vector<bool> node = io::nodes(state);
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    if (node[i]) continue;
    const Vec3 reach = Vec3::Constant(state.grains.radius[i]);
    low = low.cwiseMin(state.grains.position[i] - reach), high = high.cwiseMax(state.grains.position[i] + reach);
  }
  Vec3 all = high - low;
  for (int axis = 0; axis < 3; ++axis)
    if (state.cell.periodic[static_cast<std::size_t>(axis)]) all[axis] = state.cell.matrix.row(axis).cwiseAbs().sum();
  return all;
}

// Throws DataError for a box that is much larger than the grains.
void judge_size(const io::Snapshot& state, const std::vector<double>& b, const std::string& text,
                const std::string& where) {
  const Vec3 extent = extents(state);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (int axis = 0; axis < state.grains.dimension; ++axis) {
    const auto at = static_cast<std::size_t>(2 * axis);
    const double ratio = (b[at + 1] - b[at]) / extent[axis];
    least = std::min(least, ratio), most = std::max(most, ratio);
  }
  if (least > large_edge || most > largest_edge)
    throw DataError(fmt::format(
        "{}: --box {}: an edge has {:.0f} times the extent of the state, which is {}: coordinates are in "
        "metres, as 0.015 for 15 mm",
        where, text, most,
        state.grains.dimension == 3
            ? fmt::format("{:.3g}, {:.3g} and {:.3g} m along x, y and z", extent.x(), extent.y(), extent.z())
            : fmt::format("{:.3g} and {:.3g} m along x and y", extent.x(), extent.y())));
}

}  // namespace

void VolumeChoice::check(std::vector<std::string>& wrong) const {
  for (const std::string& text : boxes) {
    const std::vector<double> b = numbers_of_list(text);
    bool rises = b.size() == 4 || b.size() == 6;
    for (std::size_t k = 1; rises && k < b.size(); k += 2) rises = b[k - 1] < b[k];
    if (std::ranges::count(boxes, text) > 1 && wrong.empty())
      wrong.push_back(fmt::format("--box {} is given twice, and would be two volumes: give it once", text));
    if (!rises)
      wrong.push_back(
          fmt::format("--box {}: give x, y and z from low to high, as in 0,0.1,0,0.1,0,0.2 (of disks x and y)", text));
  }
}

std::vector<Volume> VolumeChoice::volumes(const io::Snapshot& state, const std::string& where) const {
  std::vector<Volume> all;
  const auto take = [&](std::vector<Volume> some, std::string_view absent) {
    if (some.empty()) throw DataError(fmt::format("{}: {}; take --box", where, absent));
    for (Volume& one : some) all.push_back(std::move(one));
  };
  if (copies) take(analysis::copies(state), "holds no copies of a representative volume");
  if (groups)
    take(analysis::groups(state), "has no groups along x, which need copies in one layer, as many along x as along y");
  for (const std::string& text : boxes) {
    std::vector<double> b = numbers_of_list(text);
    const bool disks = state.grains.dimension == 2;
    if (disks != (b.size() == 4))
      throw DataError(fmt::format("{}: --box {}: has {} numbers, and {}", where, text, b.size(),
                                  disks ? "the grains are disks, which have no z: give X0,X1,Y0,Y1, where y is up"
                                        : "the grains are spheres: give X0,X1,Y0,Y1,Z0,Z1"));
    if (disks) b.insert(b.end(), {-1, 1});
    judge_size(state, b, text, where);
    all.push_back(box(state, {b[0], b[2], b[4]}, {b[1], b[3], b[5]}));
  }
  return all;
}

}  // namespace soilweave::analysis
