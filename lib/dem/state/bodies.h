// Grains as rows: a vector and the scalar used with it lie side by side, one aligned load each. Velocities are
// fluctuations about the cell's affine motion, half a step behind the positions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/large_pages.h"
#include "core/simd/v3.h"
#include "files/records.h"

namespace soilweave::dem {

/// One grain in two cache lines. In the plane the spin is the third component of the velocity.
struct alignas(64) Grain {
  /// Position x, y, z, m; radius, m.
  Lane4 position;
  /// Velocity, m/s; mass, kg.
  Lane4 velocity;
  /// Spin, rad/s; radius again, m.
  Lane4 spin;
  /// Quaternion in the order w x y z; disks use Bodies::angle.
  Lane4 orientation;
};

/// Resultant force and torque on a grain, one cache line. In the plane the torque is the third component of the force,
/// and the row of the torque is zero.
struct alignas(64) Load {
  /// Force, N, and torque, N m; the last component is 0.
  Lane4 force{}, torque{};
};

/// Returns the volume of a sphere (m3) or the area of a disk (m2).
double grain_volume(int dimension, double radius);

/// Byte offset of grain `index` from the first grain. `load_distance` is the same for the array of loads.
inline std::uint32_t grain_distance(std::size_t index) { return static_cast<std::uint32_t>(index * sizeof(Grain)); }
inline std::uint32_t load_distance(std::size_t index) { return static_cast<std::uint32_t>(index * sizeof(Load)); }

/// All grains of a simulation: spheres, disks, and nodes of geotextiles.
struct Bodies {
  /// Dimension of the space, 2 or 3.
  int dimension = 3;
  /// Moment of inertia over (mass times squared radius).
  double gyration;
  /// Grains, in the order of files.
  LargeVector<Grain> grains;
  LargeVector<double> angle;  // rotation of disks about the normal of their plane, rad
  // One load per grain: the resultant without gravity, from Motion::collect to Motion::advance. During a sweep, loads
  // of single pairs follow (Contacts::single_loads).
  LargeVector<Load> loads;
  // Stiffness of the contacts, laid out like the loads. Zero except while a step evaluates it.
  LargeVector<Load> stiffness;
  // 1 / (skin distance of the grain)², 1/m2.
  LargeVector<double> per_leeway2;
  /// Material of each grain.
  std::vector<std::int32_t> material;
  /// Whether all grains have one material.
  bool of_one_material;
  /// Fabric of a geotextile node, -1 for soil; empty if all are soil.
  std::vector<std::int32_t> fabric;

  /// Takes the grains of a record, without their identities.
  explicit Bodies(const io::GrainsRecord& record);
  /// Return number, radius and mass of grains.
  std::size_t size() const { return grains.size(); }
  double radius(std::size_t i) const { return grains[i].position[3]; }
  double mass(std::size_t i) const { return grains[i].velocity[3]; }
  /// Returns the moment of inertia, kg m2; infinite for nodes of geotextiles, which do not rotate.
  double inertia(std::size_t i) const {
    return is_node(i) ? std::numeric_limits<double>::infinity() : gyration * mass(i) * radius(i) * radius(i);
  }

  /// Return the fluctuation velocity, m/s, with the mass, and the spin, rad/s, with the radius.
  Lane4 velocity(std::size_t i) const {
    const Lane4& v = grains[i].velocity;
    return dimension == 2 ? Lane4{v[0], v[1], 0, v[3]} : v;
  }
  Lane4 spin(std::size_t i) const {
    return dimension == 2 ? Lane4{0, 0, grains[i].velocity[2], radius(i)} : grains[i].spin;
  }
  /// Set velocity, m/s, and spin, rad/s, of one grain.
  void set_velocity(std::size_t i, const Vec3& v);
  void set_spin(std::size_t i, const Vec3& spin);

  /// Return the force, N, and the torque, N m, on a grain.
  Lane4 force(std::size_t i) const {
    const Lane4& f = loads[i].force;
    return dimension == 2 ? Lane4{f[0], f[1], 0, 0} : f;
  }
  Lane4 torque(std::size_t i) const { return dimension == 2 ? Lane4{0, 0, loads[i].force[2], 0} : loads[i].torque; }

  /// Returns whether a grain is a node of a geotextile.
  bool is_node(std::size_t i) const { return !fabric.empty() && fabric[i] >= 0; }
  /// Returns whether two nodes belong to one fabric. These touch only across a periodic face.
  bool in_one_fabric(std::size_t i, std::size_t j) const { return is_node(i) && fabric[i] == fabric[j]; }
  /// Makes grains the nodes of fabrics, which do not rotate.
  void set_fabric(std::vector<std::int32_t> fabric_of);

  /// Scales the radii at constant density, and the coordinates by `stretch`. Nodes stay. Inertia follows.
  void scale_radii(double factor, const Vec3& stretch);
  /// Returns the volume of the grains, m3 (2D: m2). Overlaps count twice.
  double solid_volume() const;
  /// Return extremes over all grains, m, kg and kg m2; inertia without nodes.
  double largest_radius() const;
  double smallest_radius() const;
  double smallest_mass() const;
  double smallest_inertia() const;
  double total_mass() const;
  /// Returns the part of a record that Bodies lacks: the identities.
  static io::GrainsRecord identities(io::GrainsRecord record);
  /// Writes positions, velocities, orientations, radii and masses into a record of identities.
  void store(io::GrainsRecord& record) const;
};

}  // namespace soilweave::dem
