// Doubts about planes that do not start where the input ended.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/doubts/plane_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "dem/state/plane.h"

namespace soilweave::analysis {
namespace {

using dem::Plane;

// Largest distance of a plane from its place in the input, over its depth in the grains. It changes the plane's force
// by less than a fiftieth.
constexpr double displaced = 0.01;

std::string name_of(std::size_t plane, const dem::Scenario& scenario) {
  for (const dem::PartSetting& p : scenario.parts)
    if (!p.part.is_clamp && p.part.number == plane) return "\"" + p.part.name + "\"";
  return std::to_string(plane);
}

// Returns how deep each plane presses into the grains that touch it, m; 0 for a plane that none touches.
std::vector<double> depths(const io::Snapshot& state, const std::vector<Plane>& planes) {
  std::vector<double> depth(planes.size(), 0);
  for (const auto& [first, second] : state.contacts.bodies) {
    if (second >= 0) continue;
    const auto grain = static_cast<std::size_t>(first);
    const Plane& plane = planes[dem::plane_number(second)];
    const double height = (state.grains.position[grain] - plane.point).dot(plane.normal);
    double& deepest = depth[dem::plane_number(second)];
    deepest = std::max(deepest, state.grains.radius[grain] - height);
  }
  return depth;
}

// Returns the number of the nearest plane to `plane` that has its normal and its partners; none if there is none.
std::optional<std::size_t> successor(const Plane& plane, const std::vector<Plane>& planes) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const double distance = std::abs((planes[k].point - plane.point).dot(plane.normal));
    if (planes[k].partners != plane.partners || !planes[k].normal.isApprox(plane.normal) || !(distance < least))
      continue;
    least = distance, nearest = k;
  }
  return nearest;
}

}  // namespace

std::vector<Doubt> moved_plane_doubts(const io::Snapshot& packing, const io::Snapshot& state,
                                      const dem::Scenario& scenario) {
  const std::vector<Plane> input = dem::Planes(packing.planes).all, planes = dem::Planes(state.planes).all;
  const std::vector<double> depth = depths(packing, input);
  std::vector<Doubt> all;
  for (std::size_t k = 0; k < input.size(); ++k) {
    if (!(depth[k] > 0)) continue;
    const Plane& before = input[k];
    const std::optional<std::size_t> now = successor(before, planes);
    if (!now || std::ranges::count(scenario.touching, *now) > 0) continue;
    const double ahead = (planes[*now].point - before.point).dot(before.normal);
    if (std::abs(ahead) <= displaced * depth[k]) continue;
    const Vec3& point = before.point;
    all.push_back(
        {fmt::format("moved-plane-{}", *now),
         fmt::format("plane {} starts {:.4g} m {} its place at the end of the input, where grains press on "
                     "it: {}; give it point = [{}, {}, {}]",
                     name_of(*now, scenario), std::abs(ahead), ahead < 0 ? "behind" : "ahead of",
                     ahead < 0 ? "it lets them go" : "it presses them further", point.x(), point.y(), point.z())});
  }
  return all;
}

}  // namespace soilweave::analysis
