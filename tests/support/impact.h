// One or two spheres, with or without a rigid plane at z = 0, run through the whole engine.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "dem/engine/simulation.h"

namespace soilweave::dem::test {

struct Sphere {
  double radius, density;
  Vec3 position, velocity, spin = Vec3::Zero();

  double mass() const { return density * 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3); }
};

/// Returns the scene. Material 0 is the first sphere's, 1 the second's, 2 the plane's.
inline io::Snapshot scene(const std::vector<Sphere>& spheres, bool plane) {
  io::Snapshot s;
  s.cell.periodic = {false, false, false};
  s.cell.matrix = 20 * spheres.back().radius * Mat3::Identity();
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    s.grains.body_id.push_back(static_cast<std::int64_t>(i));
    s.grains.position.push_back(spheres[i].position);
    s.grains.orientation.push_back(Vec4(1, 0, 0, 0));
    s.grains.velocity.push_back(spheres[i].velocity);
    s.grains.angular_velocity.push_back(spheres[i].spin);
    s.grains.radius.push_back(spheres[i].radius);
    s.grains.mass.push_back(spheres[i].mass());
    s.grains.material_id.push_back(static_cast<std::int32_t>(i));
    s.grains.copy_id.push_back(0);
  }
  if (plane) {
    s.planes.point = {Vec3::Zero()};
    s.planes.normal = {Vec3::UnitZ()};
    s.planes.velocity = {Vec3::Zero()};
    s.planes.material_id = {2};
  }
  return s;
}

inline Numerics undamped(double time_step, double gravity = 0) {
  Numerics n;
  n.damping = 0;
  n.time_step = time_step;
  n.gravity = Vec3(0, 0, -gravity);
  return n;
}

/// Result of an impact: peaks over the contact, its duration, and the state after it.
struct Impact {
  double largest_overlap = 0, largest_force = 0, duration = 0;  // m, N, s
  io::GrainsRecord after;
};

/// Runs from touching until the contact ends. Throws std::runtime_error if it never does.
inline Impact collide(const std::vector<Sphere>& spheres, bool plane, const Model& model, double time_step,
                      int most_steps = 1000000) {
  Simulation simulation(scene(spheres, plane), model, undamped(time_step));
  Impact impact;
  for (int i = 0; i < most_steps; ++i) {
    simulation.step();
    const io::Snapshot s = simulation.snapshot();
    if (s.contacts.size() == 0) {
      impact.duration = simulation.time();
      impact.after = s.grains;
      return impact;
    }
    impact.largest_overlap = std::max(impact.largest_overlap, s.contacts.overlap[0]);
    impact.largest_force = std::max(impact.largest_force, s.contacts.normal_force[0]);
  }
  throw std::runtime_error("the spheres never parted");
}

/// Hertz's impact of reduced mass m and radius R at relative speed v: peak overlap and force, and contact time.
struct HertzImpact {
  double overlap, force, duration;

  HertzImpact(double E_star, double R, double m, double v)
      : overlap(std::pow(15 * m * v * v / (16 * E_star * std::sqrt(R)), 0.4)),
        force(4.0 / 3.0 * E_star * std::sqrt(R) * std::pow(overlap, 1.5)),
        duration(2.9432 * overlap / v) {}
};

}  // namespace soilweave::dem::test
