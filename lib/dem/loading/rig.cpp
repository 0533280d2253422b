// Drives the named plates and clamps of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace soilweave::dem {
namespace {

// Frequency times step of a massless plate. The plate moves like a critically damped mass that would oscillate on its
// contacts at this frequency.
constexpr double plate_frequency_times_step = 0.1;
// Tolerance of a displacement, m.
constexpr double displacement_tolerance = 1e-10;
// Planes face each other if the cosine between their normals is below minus this.
constexpr double opposite = 0.99;

Vec3 middle(const Clamp& clamp, const Bodies& bodies) {
  Vec3 sum = Vec3::Zero();
  for (const std::int32_t i : clamp.grains) sum += vector_of(bodies.grains[static_cast<std::size_t>(i)].position);
  return sum / static_cast<double>(clamp.grains.size());
}

}  // namespace

bool face_each_other(const Vec3& one, const Vec3& other) { return one.dot(other) < -opposite; }

std::size_t Rig::index(const std::string& name) const {
  for (std::size_t p = 0; p < parts_.size(); ++p)
    if (parts_[p].name == name) return p;
  throw DataError(fmt::format("no [[plane]] or [[clamp]] is called \"{}\"", name));
}

bool Rig::loaded() const {
  return std::any_of(states_.begin(), states_.end(), [](const State& s) { return s.loaded; });
}

void Rig::begin_stage() {
  for (State& s : states_) s.at_start = s.displacement;
}

Vec3 Rig::force(std::size_t part, const std::vector<PlateLoad>& plates, const Simulation& simulation) const {
  const RigPart& p = parts_[part];
  return p.is_clamp ? simulation.clamps()[p.number].force : plates[p.number].force;
}

double Rig::load_velocity(std::size_t part, const std::vector<PlateLoad>& plates, double damping,
                          const Simulation& simulation) {
  State& s = states_[part];
  const double dt = simulation.time_step();
  const double error =
      s.load + force(part, plates, simulation).dot(s.direction);  // part of the load that the grains do not bear yet, N
  double mass = parts_[part].mass, direct = 0;
  if (mass == 0 && !parts_[part].is_clamp) {
    // A plate without contacts approaches at its full speed.
    const double stiffness = plates[parts_[part].number].stiffness;
    if (stiffness == 0) return s.velocity = s.load > 0 ? s.speed : 0.0;
    const double omega = plate_frequency_times_step / dt;
    mass = stiffness / (omega * omega);
    direct = 2 * omega * error / stiffness;
  }
  const double side = s.velocity * error > 0 ? 1 : (s.velocity * error < 0 ? -1 : 0);
  const double damped = direct == 0 ? damping * side : 0.0;
  s.velocity = std::clamp(s.velocity + (1 - damped) * dt * error / mass, -s.speed, s.speed);
  return std::clamp(s.velocity + direct, -s.speed, s.speed);
}

void Rig::drive(const std::vector<DriveGoal>& goals, double damping, Simulation& simulation, double pace) {
  if (!any()) return;
  const double dt = simulation.time_step();
  const bool loads = loaded() || std::any_of(goals.begin(), goals.end(),
                                             [](const DriveGoal& goal) { return goal.kind == DriveGoal::Kind::load; });
  const std::vector<PlateLoad> plates = loads ? simulation.plate_loads() : std::vector<PlateLoad>();
  std::vector<Vec3> velocity(parts_.size(), Vec3::Zero());
  for (const DriveGoal& goal : goals) {
    const std::size_t p = index(goal.part);
    State& s = states_[p];
    if (goal.kind == DriveGoal::Kind::load) {
      if (!s.loaded) s.velocity = 0;
      s.loaded = true;
      s.direction = goal.direction, s.load = goal.value, s.speed = goal.speed;
    } else {
      if (s.loaded && std::abs(s.direction.dot(goal.direction)) > along_load) s.loaded = false;
      const double left = goal.value - (s.displacement - s.at_start).dot(goal.direction);
      const double speed = pace * goal.speed;
      velocity[p] += std::clamp(left / dt, -speed, speed) * goal.direction;
    }
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    State& s = states_[p];
    if (s.loaded) velocity[p] += load_velocity(p, plates, damping, simulation) * s.direction;
    s.displacement += dt * velocity[p];
    const RigPart& part = parts_[p];
    if (!part.is_clamp)
      simulation.set_plane_velocity(part.number, velocity[p]);
    else if (simulation.clamps()[part.number].velocity != velocity[p])
      simulation.set_clamp_velocity(part.number, velocity[p]);
  }
}

std::vector<Rig::Facing> Rig::facing(const Simulation& simulation) const {
  const auto place = [&](const RigPart& p) {
    return p.is_clamp ? middle(simulation.clamps()[p.number], simulation.bodies())
                      : simulation.planes().all[p.number].point;
  };
  const auto& planes = simulation.planes().all;
  std::vector<Facing> pairs;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (std::size_t q = p + 1; q < parts_.size(); ++q) {
      if (parts_[p].is_clamp != parts_[q].is_clamp) continue;
      const Vec3 apart = place(parts_[q]) - place(parts_[p]);
      Vec3 across = apart.norm() > 0 ? Vec3(apart.normalized()) : Vec3(Vec3::Zero());
      if (!parts_[p].is_clamp) {
        across = planes[parts_[p].number].normal;
        if (!face_each_other(across, planes[parts_[q].number].normal)) continue;
      }
      if (apart.dot(across) > 0) pairs.push_back({p, q, across, apart.dot(across)});
    }
  return pairs;
}

Mat3 Rig::gradient_of_way(const std::vector<DriveGoal>& goals, double pace, const Mat3& before,
                          const Simulation& simulation) const {
  std::vector<Vec3> velocity(parts_.size(), Vec3::Zero());
  for (const DriveGoal& goal : goals) {
    if (goal.kind != DriveGoal::Kind::displacement) continue;
    const std::size_t p = index(goal.part);
    const double left = goal.value - (states_[p].displacement - states_[p].at_start).dot(goal.direction);
    if (std::abs(left) > displacement_tolerance) velocity[p] += std::copysign(pace * goal.speed, left) * goal.direction;
  }
  Mat3 gradient = before;
  for (const Facing& pair : facing(simulation)) {
    Vec3 change = (velocity[pair.second] - velocity[pair.first]) / pair.distance - gradient * pair.across;
    for (const std::size_t p : {pair.first, pair.second})
      if (states_[p].loaded) change -= change.dot(states_[p].direction) * states_[p].direction;
    gradient += change * pair.across.transpose();
  }
  return gradient;
}

bool Rig::moved(const std::vector<DriveGoal>& goals) const {
  for (const DriveGoal& goal : goals) {
    if (goal.kind != DriveGoal::Kind::displacement) continue;
    const State& s = states_[index(goal.part)];
    const double left = goal.value - (s.displacement - s.at_start).dot(goal.direction);
    if (std::abs(left) > displacement_tolerance) return false;
  }
  return true;
}

bool Rig::arrived(const std::vector<DriveGoal>& goals, double tolerance, const Simulation& simulation) const {
  if (!moved(goals)) return false;
  if (!loaded()) return true;
  const std::vector<PlateLoad> plates = simulation.plate_loads();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const State& s = states_[p];
    if (s.loaded && std::abs(s.load + force(p, plates, simulation).dot(s.direction)) > tolerance * std::abs(s.load))
      return false;
  }
  return true;
}

std::string Rig::late_part(const std::vector<DriveGoal>& goals, double tolerance, const Simulation& simulation) const {
  for (const DriveGoal& goal : goals) {
    if (goal.kind != DriveGoal::Kind::displacement) continue;
    const State& s = states_[index(goal.part)];
    const double way = (s.displacement - s.at_start).dot(goal.direction);
    if (std::abs(goal.value - way) > displacement_tolerance)
      return fmt::format("\"{}\" has moved {:.4g} of {:.4g} m: raise equilibrium.steps or its speed", goal.part, way,
                         goal.value);
  }
  if (!loaded()) return {};
  const std::vector<PlateLoad> plates = simulation.plate_loads();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const State& s = states_[p];
    const double borne = -force(p, plates, simulation).dot(s.direction);
    if (!s.loaded || std::abs(s.load - borne) <= tolerance * std::abs(s.load)) continue;
    if (!parts_[p].is_clamp && plates[parts_[p].number].stiffness == 0)
      return fmt::format(
          "\"{}\" touches no grain: turn its load of {:.4g} N towards the grains, or raise its speed or "
          "equilibrium.steps",
          parts_[p].name, s.load);
    return fmt::format("the grains bear {:.4g} of the load of {:.4g} N on \"{}\": raise equilibrium.steps or its speed",
                       borne, s.load, parts_[p].name);
  }
  return {};
}

void Rig::record(const Simulation& simulation, io::Series& series) const {
  if (!any()) return;
  const std::vector<PlateLoad> plates = simulation.plate_loads();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Vec3 f = force(p, plates, simulation);
    for (int a = 0; a < 3; ++a) {
      const std::string suffix = parts_[p].name + "_" + "xyz"[a];
      append(series, "displacement_" + suffix, "m", "displacement of the part since the start",
             states_[p].displacement[a]);
      append(series, "force_" + suffix, "N", "force of the grains on the part", f[a]);
    }
  }
}

std::string Rig::text(const Simulation& simulation) const {
  const std::vector<PlateLoad> plates = simulation.plate_loads();
  std::string all;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    all += fmt::format("{}{} at {:.3g} mm under {:.3g} N", p ? ", " : "", parts_[p].name,
                       1e3 * states_[p].displacement.norm(), force(p, plates, simulation).norm());
  return all;
}

void Rig::archive(Archive& a) {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    State& s = states_[p];
    const auto name = [p](const char* what) { return fmt::format("rig_{}_{}", p, what); };
    a.item(name("displacement"), s.displacement), a.item(name("at_start"), s.at_start);
    a.whole(name("loaded"), s.loaded), a.item(name("direction"), s.direction);
    a.item(name("load"), s.load), a.item(name("speed"), s.speed), a.item(name("velocity"), s.velocity);
  }
}

void append(io::Series& series, const std::string& name, const std::string& unit, const std::string& long_name,
            double value) {
  for (io::Column& column : series.columns)
    if (column.name == name) return column.values.push_back(value);
  series.columns.push_back({name, unit, long_name, {value}});
}

}  // namespace soilweave::dem
