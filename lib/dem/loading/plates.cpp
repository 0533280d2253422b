// Checks of the orders of a stage.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/plates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace soilweave::dem {
namespace {

// Ratio of a height to the plates' distance, or its inverse, above which the height is doubted. Before compression
// plates may stand off a bag, in chapter 3 by a fifth of its height.
constexpr double doubted_factor = 1.5;
// Cosine between the direction of a load and the plate's normal below which the load pulls.
constexpr double pulling = -0.01;

}  // namespace

std::string contradiction(const std::vector<DriveGoal>& goals) {
  for (std::size_t k = 0; k < goals.size(); ++k)
    for (std::size_t other = 0; other < k; ++other) {
      if (goals[k].part != goals[other].part) continue;
      const int loads = (goals[k].kind == DriveGoal::Kind::load) + (goals[other].kind == DriveGoal::Kind::load);
      const bool along = std::abs(goals[k].direction.dot(goals[other].direction)) > along_load;
      const std::string& name = goals[k].part;
      if (loads == 2) return fmt::format("loads \"{}\" twice: give one load, the resultant", name);
      if (loads == 1 && along)
        return fmt::format(
            "moves \"{}\" along its load, which it then no longer carries: leave out the move or the load", name);
      if (loads == 0 && along) return fmt::format("moves \"{}\" twice along one direction: give one move", name);
    }
  return {};
}

const RigPart* Plates::part(const std::string& name) const {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const RigPart& p) { return p.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

double Plates::distance_along_z(const RigPart& lower, const RigPart& upper) const {
  if (!face_each_other(planes.normal[lower.number].normalized(), -Vec3::UnitZ()) ||
      !face_each_other(planes.normal[upper.number].normalized(), Vec3::UnitZ()))
    return 0;
  return std::max(0.0, planes.point[upper.number].z() - planes.point[lower.number].z());
}

std::string Plates::misfit(const Path& path, int dimension) const {
  if (path.least_dimension() > dimension)
    return "loads along z, and the packing is of disks in the plane of x and y: load along y, or leave z out";
  const std::optional<Between> between = path.between();
  if (!between) return {};
  const RigPart *lower = part(between->lower), *upper = part(between->upper);
  if (!lower || !upper)
    return fmt::format(
        "compresses between \"{}\" and \"{}\", but no [[plane]] or [[clamp]] is called \"{}\": name one "
        "so, or give lower and upper",
        between->lower, between->upper, lower ? between->upper : between->lower);
  if (lower->is_clamp || upper->is_clamp || distance_along_z(*lower, *upper) > 0) return {};
  return fmt::format(
      "moves \"{}\" up and \"{}\" down, but these planes do not face each other along z: give as lower "
      "the plane whose normal is [0, 0, 1], and as upper the one with [0, 0, -1], or take path = \"drive\"",
      between->lower, between->upper);
}

std::vector<Doubt> Plates::doubts(const std::string& stage, const Path& path) const {
  std::vector<Doubt> all;
  if (const std::optional<Between> between = path.between()) {
    const RigPart &lower = *part(between->lower), &upper = *part(between->upper);
    const double distance = lower.is_clamp || upper.is_clamp ? 0 : distance_along_z(lower, upper);
    if (distance > 0 && std::max(distance / between->height, between->height / distance) > doubted_factor)
      all.push_back({"height", fmt::format("stage \"{}\" takes strains of a height of {:.4g} m, and its plates start "
                                           "{:.4g} m apart: compare the height with that of the specimen",
                                           stage, between->height, distance)});
  }
  for (const DriveGoal& goal : path.drives(path.stations() - 1)) {
    const RigPart& p = *part(goal.part);
    if (goal.kind != DriveGoal::Kind::load || goal.value == 0 || p.is_clamp) continue;
    if (goal.direction.dot(planes.normal[p.number].normalized()) < pulling)
      all.push_back(
          {"pull", fmt::format("stage \"{}\" loads \"{}\" away from the grains, which hold it by adhesion alone: "
                               "give along towards the grains",
                               stage, goal.part)});
  }
  return all;
}

}  // namespace soilweave::dem
