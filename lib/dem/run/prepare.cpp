// Prepares a packing for a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/text/text.h"
#include "dem/engine/described.h"
#include "dem/engine/mass_scaling.h"
#include "dem/loading/plates.h"
#include "dem/loading/rig.h"
#include "dem/state/bodies.h"

namespace soilweave::dem {
namespace {

// Greatest overlap over radius of a named plane at the start. Beyond it the plane counts as inside the grains.
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
  for (std::size_t c = 0; c < all.size(); ++c)
    if (all.bodies[c][1] >= 0) left.append(all, c);
  return left;
}

bool are_parallel(const io::PlanesRecord& a, const io::PlanesRecord& b) {
  return std::equal(a.normal.begin(), a.normal.end(), b.normal.begin(), b.normal.end(),
                    [](const Vec3& m, const Vec3& n) { return m.normalized().isApprox(n.normalized()); });
}

// Returns the axial strains by which stations can be listed: nominal strains, or strains since the start of the stage
// and since the reference. Strains since the reference are unknown after a stage that ends at a stress.
std::vector<double> known_stations(const io::Snapshot& packing, const Scenario& scenario) {
  const int axis = packing.grains.dimension - 1;
  const PathState unloaded{packing.grains.dimension, Mat3::Zero(), Vec3::Zero()};
  std::vector<double> known;
  // Natural strain since the packing's reference, as in Simulation::strain().
  std::optional<double> start = 0.0 - std::log(packing.cell.deformation_gradient(axis, axis));
  for (const Stage& stage : scenario.stages) {
    if (stage.reset_strain) start = 0.0;
    std::optional<double> last = start;
    for (std::size_t station = 0; station < stage.path->stations(); ++station) {
      const double nominal = stage.path->nominal_strain(station);
      const AxisGoal goal = stage.path->goals(station, unloaded)[static_cast<std::size_t>(axis)];
      const bool strained = goal.kind == AxisGoal::Kind::strain;
      last = strained && start ? std::optional(*start + goal.value) : std::nullopt;
      if (!std::isnan(nominal)) {
        known.push_back(nominal);
      } else if (strained) {
        known.push_back(goal.value);
        if (last) known.push_back(*last);
      }
    }
    start = last;
  }
  return known;
}

void demand_recorded(const io::Snapshot& packing, const Scenario& scenario) {
  if (scenario.snapshots.which != SnapshotRule::Which::list) return;
  const std::vector<double> known = known_stations(packing, scenario);
  std::string lost;
  for (const double strain : scenario.snapshots.strains) {
    if (is_at(known, strain)) continue;
    lost += (lost.empty() ? "" : ", ") + number_text(strain);
    const auto nearest = std::min_element(
        known.begin(), known.end(), [&](double a, double b) { return std::abs(a - strain) < std::abs(b - strain); });
    if (nearest != known.end()) lost += fmt::format(" (the nearest is {:.6g})", *nearest);
  }
  if (!lost.empty())
    throw DataError(fmt::format("record.strains: {}: no station has this axial strain; give strains of stations{}",
                                lost, known.empty() ? ", which no stage here has: leave the list out" : ""));
}

Plane plane_of(const io::Snapshot& state, std::size_t k) {
  return {state.planes.point[k], state.planes.normal[k].normalized(), Vec3::Zero(), 0,
          static_cast<Partners>(state.planes.partners[k])};
}

// Moves planes along their normals until they just touch the outermost grain that may touch them.
void put_in_touch(io::Snapshot& state, const Scenario& scenario) {
  const std::vector<bool> node = io::nodes(state);
  for (const std::size_t k : scenario.touching) {
    const Plane plane = plane_of(state, k);
    double lowest = std::numeric_limits<double>::infinity();
    Vec3 middle = Vec3::Zero();
    double met = 0;
    for (std::size_t i = 0; i < state.grains.size(); ++i) {
      if (!plane.touches(node[i])) continue;
      lowest = std::min(lowest, state.grains.position[i].dot(plane.normal) - state.grains.radius[i]);
      middle += state.grains.position[i], met += 1;
    }
    if (met == 0) throw DataError(fmt::format("plane {}: point = \"touch\": no grain is its partner", k));
    middle /= met;
    state.planes.point[k] = middle + (lowest - middle.dot(plane.normal)) * plane.normal;
  }
}

std::string name_of(std::size_t plane, const Scenario& scenario) {
  for (const PartSetting& p : scenario.parts)
    if (!p.part.is_clamp && p.part.number == plane) return "\"" + p.part.name + "\"";
  return std::to_string(plane);
}

// Throws DataError for a plane of the scenario that starts inside its grains. Named planes may overlap grains a little,
// planes without a name as much as contacts may.
void demand_outside(const io::Snapshot& state, const Scenario& scenario) {
  const std::vector<bool> node = io::nodes(state);
  for (std::size_t k = 0; k < scenario.planes.point.size(); ++k) {
    const std::string name = name_of(k, scenario);
    const double allowed = name.front() == '"' ? deepest_start : scenario.numerics.limits.overlap;
    const Plane plane = plane_of(state, k);
    std::size_t deepest = 0, inside = 0;
    double depth = 0;
    for (std::size_t i = 0; i < state.grains.size(); ++i) {
      const double r = state.grains.radius[i], gap = (state.grains.position[i] - plane.point).dot(plane.normal) - r;
      if (!plane.touches(node[i]) || !(gap < -allowed * r)) continue;
      ++inside;
      if (-gap > depth) depth = -gap, deepest = i;
    }
    if (inside > 0)
      throw DataError(fmt::format(
          "plane {} starts inside the grains: {} of them reach beyond it, the deepest, grain {}, by {:.4g} m; move its "
          "point by that much against its normal, or give point = \"touch\"",
          name, inside, deepest, depth));
  }
}

void demand_free_faces(const io::Snapshot& state, const Scenario& scenario) {
  const auto found = plane_between_images(state);
  if (!found) return;
  const std::string box =
      state.grains.dimension == 2
          ? ""
          : "fill a box from the packing first (filter-expand packing.h5 box.toml -o box.h5, with a "
            "[container] of shape \"box\"), or ";
  throw DataError(
      fmt::format("plane {} stands across {}, along which the cell is periodic and grains touch their images through "
                  "its faces; the plane would bear a part of the load only: {}leave the plane out",
                  name_of(found->first, scenario), "xyz"[found->second], box));
}

void demand_held(const io::Snapshot& state, const Scenario& scenario) {
  std::map<std::int32_t, std::string> holder;
  for (const auto& [part, low, high] : scenario.parts) {
    if (!part.is_clamp) continue;
    const std::vector<std::int32_t> held = nodes_within(state, low, high);
    if (held.empty()) throw DataError(fmt::format("clamp {} holds no node: move its box", part.name));
    for (const std::int32_t node : held)
      if (!holder.emplace(node, part.name).second)
        throw DataError(fmt::format("clamps {} and {} both hold node {}: move a box", holder[node], part.name, node));
  }
}

bool are_facing(const PartSetting& one, const PartSetting& other, const io::PlanesRecord& planes) {
  if (one.part.is_clamp || other.part.is_clamp) return one.part.is_clamp && other.part.is_clamp;
  return face_each_other(planes.normal[one.part.number].normalized(), planes.normal[other.part.number].normalized());
}

void demand_open(const io::Snapshot& state, const Scenario& scenario) {
  const auto open = state.cell.periodic.begin();
  if (!std::all_of(open, open + state.grains.dimension, [](bool periodic) { return periodic; })) return;
  for (const Stage& stage : scenario.stages)
    if (stage.critical_drag)
      throw DataError(
          fmt::format("stage \"{}\": rest_drag = \"critical\" follows how grains swing between plates, and the cell is "
                      "periodic along all axes: give a number, or leave it out",
                      stage.name));
}

void demand_facing(const Scenario& scenario) {
  const std::vector<PartSetting>& parts = scenario.parts;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)
      if (are_facing(parts[p], parts[q], scenario.planes)) return;
  for (const Stage& stage : scenario.stages)
    if (stage.homogeneous_start)
      throw DataError(
          fmt::format("stage \"{}\": homogeneous_start needs two named planes that face each other, or two clamps: "
                      "leave it out",
                      stage.name));
}

// Throws DataError for a stage that gives planes a friction angle if there are none, or if grains share their material.
void demand_own_material(const io::Snapshot& state, const Stage& stage) {
  if (!stage.plate_friction) return;
  if (state.planes.point.empty())
    throw DataError(fmt::format(
        "stage \"{}\": plate_friction_angle is given, but there are no planes: give [[plane]] tables, or leave it out",
        stage.name));
  const std::vector<std::int32_t>& grains = state.grains.material_id;
  for (const std::int32_t material : state.planes.material_id)
    if (std::find(grains.begin(), grains.end(), material) != grains.end())
      throw DataError(fmt::format(
          "stage \"{}\": plate_friction_angle would change the friction among grains too: planes share material {} "
          "with the grains; give [[plane]] tables whose material is a [[material]] of their own",
          stage.name, material));
}

void demand_fit(const io::Snapshot& state, const Scenario& scenario) {
  demand_in_plane(state, scenario.numerics.gravity);
  const std::vector<RigPart> parts = parts_of(scenario);
  for (const Stage& stage : scenario.stages) {
    demand_own_material(state, stage);
    if (const std::string why = Plates{parts, state.planes}.misfit(*stage.path, state.grains.dimension); !why.empty())
      throw DataError(fmt::format("stage \"{}\" {}", stage.name, why));
  }
}

}  // namespace

std::vector<Doubt> plate_doubts(const io::Snapshot& state, const Scenario& scenario) {
  const std::vector<RigPart> parts = parts_of(scenario);
  std::vector<Doubt> all;
  for (const Stage& stage : scenario.stages)
    for (Doubt& doubt : Plates{parts, state.planes}.doubts(stage.name, *stage.path)) all.push_back(std::move(doubt));
  return all;
}

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
  demand_recorded(packing, scenario);
  demand_facing(scenario);
  demand_open(packing, scenario);
  if (scenario.equal_steps && scenario.numerics.gravity != Vec3::Zero())
    throw DataError(
        "grains.mass_scaling = \"equal-step\" changes what grains weigh, and numerics.gravity is not zero: leave one "
        "of "
        "them out");
  io::Snapshot state = packing;
  // Planes of an earlier run stay if the scenario has none.
  if (!scenario.planes.point.empty()) state.planes = scenario.planes;
  described(state, scenario.model);
  if (scenario.grain_density > 0) set_density(state, scenario.grain_density);
  for (std::size_t i = 0; i < state.grains.size(); ++i)
    if (const auto& density = scenario.density[static_cast<std::size_t>(state.grains.material_id[i])])
      state.grains.mass[i] = *density * grain_volume(state.grains.dimension, state.grains.radius[i]);
  if (scenario.equal_steps) equalise_steps(scenario.model, state.grains);
  put_in_touch(state, scenario);
  // Contacts with planes of an earlier run do not belong to new planes.
  if (!scenario.planes.point.empty() && !are_parallel(packing.planes, state.planes))
    state.contacts = without_planes(state.contacts);
  demand_free_faces(state, scenario);
  demand_fit(state, scenario);
  const bool clamped =
      std::ranges::any_of(scenario.parts, [](const PartSetting& setting) { return setting.part.is_clamp; });
  demand_footing(state, scenario.numerics.gravity, clamped);
  demand_outside(state, scenario);
  demand_held(state, scenario);
  state.step = 0;
  state.time = 0;
  return state;
}

void demand_stable(Simulation& simulation, const Numerics& numerics) {
  if (!numerics.time_step) return;
  const double limit = simulation.stability_limit();
  if (*numerics.time_step <= limit) return;
  // Rounded down, so that the reported limit is an accepted step.
  const double digit = std::pow(10, std::floor(std::log10(limit)) - 3);
  throw DataError(fmt::format(
      "the time step of {:.4g} s is over the stable one of {:.4g} s: lower numerics.time_step, or leave it out",
      *numerics.time_step, std::floor(limit / digit) * digit));
}

}  // namespace soilweave::dem
