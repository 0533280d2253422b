// Follows how far the stages of a run move plates.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/plate_ways.h"

#include <fmt/format.h>

#include <algorithm>

#include "dem/state/plane.h"

namespace soilweave::dem {
namespace {

// Returns the largest diameter of the grains that touch both planes, m; 0 if there are none.
double widest_between(const io::Snapshot& state, const std::vector<bool>& node, const Plane& one, const Plane& other) {
  double radius = 0;
  for (std::size_t i = 0; i < state.grains.size(); ++i)
    if (one.touches(node[i]) && other.touches(node[i])) radius = std::max(radius, state.grains.radius[i]);
  return 2 * radius;
}

}  // namespace

PlateWays::PlateWays(const io::Snapshot& state, std::vector<RigPart> parts, double overlap)
    : parts_(std::move(parts)), overlap_(overlap), displacement_(state.planes.point.size(), Vec3::Zero()) {
  const std::vector<Plane> planes = Planes(state.planes).all;
  const std::vector<bool> node = io::nodes(state);
  for (std::size_t q = 0; q < planes.size(); ++q)
    for (std::size_t p = 0; p < q; ++p) {
      const double distance = (planes[q].point - planes[p].point).dot(planes[p].normal);
      if (distance <= 0 || !face_each_other(planes[p].normal, planes[q].normal)) continue;
      pairs_.push_back({p, q, planes[p].normal, distance, widest_between(state, node, planes[p], planes[q])});
    }
}

std::string PlateWays::name_of(std::size_t plane) const {
  const auto part = std::ranges::find_if(parts_, [&](const RigPart& p) { return !p.is_clamp && p.number == plane; });
  return part == parts_.end() ? std::to_string(plane) : "\"" + part->name + "\"";
}

void PlateWays::move(const std::vector<DriveGoal>& orders) {
  for (const DriveGoal& order : orders) {
    const auto part = std::ranges::find(parts_, order.part, &RigPart::name);
    if (order.kind == DriveGoal::Kind::displacement && part != parts_.end() && !part->is_clamp)
      displacement_[part->number] += order.value * order.direction;
  }
}

double PlateWays::least(const Facing& pair) const {
  const bool one_layer = pair.distance < 2 * pair.diameter;
  return std::min(pair.distance, one_layer ? (1 - overlap_) * pair.diameter : pair.diameter);
}

std::string PlateWays::follow(const Path& path) {
  const std::vector<Vec3> at_start = displacement_;
  for (std::size_t station = 0; station < path.stations(); ++station) {
    displacement_ = at_start;
    move(path.drives(station));
    for (const Facing& pair : pairs_) {
      const double distance = pair.distance + (displacement_[pair.second] - displacement_[pair.first]).dot(pair.across);
      if (distance >= least(pair)) continue;
      return fmt::format(
          "moves the planes {} and {}, {:.4g} m apart at the start, to a distance of {:.4g} m at station {}, and the "
          "largest grain between them is {:.4g} m wide: move them less; lengths without a unit are in m (\"2 mm\")",
          name_of(pair.first), name_of(pair.second), pair.distance, distance, station + 1, pair.diameter);
    }
  }
  return {};
}

}  // namespace soilweave::dem
