// A packing made ready for a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/prepare.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "dem/bodies.h"

namespace soilweave::dem {
namespace {

// A plane may press on the grains it meets by this much of their radius at the start; more, and it stands in them.
constexpr double deepest_start = 0.02;

void demand_periodic(const io::Snapshot& packing, const Scenario& scenario) {
  const PathState unloaded{packing.grains.dimension, Mat3::Zero(), Vec3::Zero()};
  for (const Stage& stage : scenario.stages)
    for (std::size_t station = 0; station < stage.path->stations(); ++station) {
      const AxisGoals goals = stage.path->goals(station, unloaded);
      for (std::size_t a = 0; a < static_cast<std::size_t>(unloaded.dimension); ++a) {
        const bool held = goals[a].kind == AxisGoal::Kind::strain && goals[a].value == 0;
        if (!packing.cell.periodic[a] && !held)
          throw DataError(
              fmt::format("stage \"{}\" loads axis {}, along which the packing's cell is not periodic: give the "
                          "packing a periodic cell, or hold the axis by a stage of path \"free\"",
                          stage.name, "xyz"[a]));
      }
    }
}

io::ContactsRecord without_planes(const io::ContactsRecord& all) {
  io::ContactsRecord left;
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (all.bodies[c][1] < 0) continue;
    left.bodies.push_back(all.bodies[c]), left.image.push_back(all.image[c]), left.normal.push_back(all.normal[c]);
    left.branch_vector.push_back(all.branch_vector[c]), left.overlap.push_back(all.overlap[c]);
    left.normal_force.push_back(all.normal_force[c]), left.shear_force.push_back(all.shear_force[c]);
    left.rolling_moment.push_back(all.rolling_moment[c]), left.twisting_moment.push_back(all.twisting_moment[c]);
    left.sliding.push_back(all.sliding[c]);
  }
  return left;
}

bool are_parallel(const io::PlanesRecord& a, const io::PlanesRecord& b) {
  return std::equal(a.normal.begin(), a.normal.end(), b.normal.begin(), b.normal.end(),
                    [](const Vec3& m, const Vec3& n) { return m.normalized().isApprox(n.normalized()); });
}

void demand_known(const io::Snapshot& state, const Scenario& scenario) {
  const auto materials = std::visit([](const auto& m) { return m.size(); }, scenario.model.materials);
  for (const std::int32_t id : state.grains.material_id)
    if (id < 0 || static_cast<std::size_t>(id) >= materials)
      throw DataError(fmt::format(
          "the packing has grains of material {}, the scenario describes {}: add [[material]] tables", id, materials));
  for (const std::int32_t id : state.yarns.geotextile_id)
    if (static_cast<std::size_t>(id) >= scenario.model.geotextiles.size())
      throw DataError(
          fmt::format("the packing has yarns of geotextile {}, the scenario describes {}: add "
                      "[[geotextile]] tables",
                      id, scenario.model.geotextiles.size()));
}

// Planes that the run brings along must not stand inside what it loads.
void demand_outside(const io::Snapshot& state, const Scenario& scenario) {
  for (const PartSetting& p : scenario.parts) {
    if (p.part.is_clamp) {
      if (nodes_within(state, p.low, p.high).empty())
        throw DataError(fmt::format("clamp \"{}\" holds no node of a geotextile: move its box", p.part.name));
      continue;
    }
    const Vec3 normal = state.planes.normal[p.part.number].normalized();
    std::vector<bool> node(state.grains.size(), false);
    for (const auto& ends : state.yarns.nodes)
      for (const std::int32_t n : ends) node[static_cast<std::size_t>(n)] = true;
    const Plane plane{state.planes.point[p.part.number], normal, Vec3::Zero(), 0,
                      static_cast<Partners>(state.planes.partners[p.part.number])};
    for (std::size_t i = 0; i < state.grains.size(); ++i) {
      const double r = state.grains.radius[i], gap = (state.grains.position[i] - plane.point).dot(normal) - r;
      if (plane.touches(node[i]) && gap < -deepest_start * r)
        throw DataError(
            fmt::format("plane \"{}\" starts inside the grains: grain {} reaches {:.3g} m beyond it; move "
                        "its point outwards by that much",
                        p.part.name, i, -gap));
    }
  }
}

}  // namespace

std::vector<std::int32_t> nodes_within(const io::Snapshot& state, const Vec3& low, const Vec3& high) {
  std::vector<std::int32_t> found;
  for (const auto& ends : state.yarns.nodes)
    for (const std::int32_t node : ends) {
      const Vec3& x = state.grains.position[static_cast<std::size_t>(node)];
      if ((x.array() >= low.array()).all() && (x.array() <= high.array()).all()) found.push_back(node);
    }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

io::Snapshot prepare(const io::Snapshot& packing, const Scenario& scenario) {
  demand_periodic(packing, scenario);
  demand_known(packing, scenario);
  io::Snapshot state = packing;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const double density = scenario.density[static_cast<std::size_t>(state.grains.material_id[i])];
    if (density > 0) state.grains.mass[i] = density * grain_volume(state.grains.dimension, state.grains.radius[i]);
  }
  if (!scenario.planes.point.empty()) {
    state.planes = scenario.planes;
    // Contacts with planes of an earlier run are not with these.
    if (!are_parallel(packing.planes, state.planes)) state.contacts = without_planes(state.contacts);
  }
  demand_outside(state, scenario);
  state.step = 0;
  state.time = 0;
  return state;
}

}  // namespace soilweave::dem
