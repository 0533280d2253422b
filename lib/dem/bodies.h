// Grains as rows: a vector and the scalar used with it side by side, one aligned load each.
// Velocities are fluctuations about the cell's affine motion, half a step behind the positions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/large_pages.h"
#include "core/v3.h"
#include "io/records.h"

namespace soilweave::dem {

/// Two cache lines. In the plane the spin is the third part of the velocity: all that moves a disk lies in the first.
struct alignas(64) Grain {
  Lane4 position;     // x, y, z, m; radius, m
  Lane4 velocity;     // m/s; mass, kg
  Lane4 spin;         // rad/s; radius, m, once more
  Lane4 orientation;  // quaternion, in the order w x y z; disks have Bodies::angle
};

/// What acts on a grain. One cache line. In the plane the torque is the third part of the force, and the other row
/// zero.
struct alignas(64) Load {
  Lane4 force{}, torque{};  // N, N m; last place 0
};

/// Of a sphere, m3; of a disk, m2.
double grain_volume(int dimension, double radius);

/// From the first grain, in bytes; from its load.
inline std::uint32_t grain_distance(std::size_t index) { return static_cast<std::uint32_t>(index * sizeof(Grain)); }
inline std::uint32_t load_distance(std::size_t index) { return static_cast<std::uint32_t>(index * sizeof(Load)); }

struct Bodies {
  int dimension = 3;
  double gyration;  // moment of inertia over mass and squared radius
  LargeVector<Grain> grains;
  LargeVector<double> angle;  // rad, of disks, turned by about the axis of their plane
  // First one of every grain: after Motion::collect the resultant of what acts on it, gravity apart, which
  // Motion::advance uses up. Then, while a sweep collects, loads of one pair each (Contacts::singles).
  LargeVector<Load> loads;
  // What contacts resist motion with, laid out like the loads (ContactSweep); zero but while a step looks at it.
  LargeVector<Load> stiffness;
  // Of how far each may move before pairs are listed anew (Neighbours), 1/m2.
  LargeVector<double> per_leeway2;
  std::vector<std::int32_t> material;
  bool of_one_material;
  std::vector<std::int32_t> fabric;  // of a node of a geotextile, -1 of soil; empty where all are soil

  explicit Bodies(const io::GrainsRecord& record);
  std::size_t size() const { return grains.size(); }
  double radius(std::size_t i) const { return grains[i].position[3]; }
  double mass(std::size_t i) const { return grains[i].velocity[3]; }
  /// kg m2; nodes of geotextiles do not rotate.
  double inertia(std::size_t i) const {
    return is_node(i) ? std::numeric_limits<double>::infinity() : gyration * mass(i) * radius(i) * radius(i);
  }

  /// Fluctuation of a grain, m/s, and its mass; rad/s, and its radius.
  Lane4 velocity(std::size_t i) const {
    const Lane4& v = grains[i].velocity;
    return dimension == 2 ? Lane4{v[0], v[1], 0, v[3]} : v;
  }
  Lane4 spin(std::size_t i) const {
    return dimension == 2 ? Lane4{0, 0, grains[i].velocity[2], radius(i)} : grains[i].spin;
  }
  void set_velocity(std::size_t i, const Vec3& v);
  void set_spin(std::size_t i, const Vec3& spin);

  /// Of what acts on a grain: N, and N m.
  Lane4 force(std::size_t i) const {
    const Lane4& f = loads[i].force;
    return dimension == 2 ? Lane4{f[0], f[1], 0, 0} : f;
  }
  Lane4 torque(std::size_t i) const { return dimension == 2 ? Lane4{0, 0, loads[i].force[2], 0} : loads[i].torque; }

  bool is_node(std::size_t i) const { return !fabric.empty() && fabric[i] >= 0; }
  /// Nodes of one fabric are held together by yarns and do not touch, except across a periodic face.
  bool in_one_fabric(std::size_t i, std::size_t j) const { return is_node(i) && fabric[i] == fabric[j]; }
  /// Makes grains the nodes of fabrics, which do not rotate.
  void set_fabric(std::vector<std::int32_t> fabric_of);

  /// Radii times factor at constant density, coordinates times those of stretch, nodes apart; inertia follows.
  void scale_radii(double factor, const Vec3& stretch);
  /// Volume of the grains, overlaps counted twice: m3 (2D: m2).
  double solid_volume() const;
  double largest_radius() const;
  double smallest_radius() const;
  double smallest_mass() const;
  double smallest_inertia() const;
  double total_mass() const;
  /// What a record holds beside what is here: the identities.
  static io::GrainsRecord identities(io::GrainsRecord record);
  /// Positions, velocities, orientations, radii and masses back into a record that holds the identities.
  void store(io::GrainsRecord& record) const;
};

}  // namespace soilweave::dem
