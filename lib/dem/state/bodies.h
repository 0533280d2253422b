// Grains as rows of four numbers: a vector, and a scalar that is used with it.
// Velocities are fluctuations about the cell's affine motion, half a step behind the positions.
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

/// Resultant force and torque on a grain, one cache line. In the plane `force[2]` is the torque.
struct alignas(64) Load {
  /// Force, N, and torque, N m, each with a last component of 0.
  Lane4 force{}, torque{};
};

/// Returns the volume of a sphere (m3) or the area of a disk (m2).
double grain_volume(int dimension, double radius);
/// Sets the masses of all grains except nodes of geotextiles from a density, kg/m3.
void set_density(io::Snapshot& state, double density);

/// Returns the byte offset of grain `index` from the first grain.
inline std::uint32_t grain_distance(std::size_t index) { return static_cast<std::uint32_t>(index * sizeof(Grain)); }
/// Returns the byte offset of load `index` from the first load.
inline std::uint32_t load_distance(std::size_t index) { return static_cast<std::uint32_t>(index * sizeof(Load)); }

/// All grains of a simulation: spheres, disks, and nodes of geotextiles.
struct Bodies {
  /// Dimension of the space, 2 or 3.
  int dimension = 3;
  /// Moment of inertia over (mass times squared radius).
  double gyration;
  /// Grains, in the order of files.
  LargeVector<Grain> grains;
  /// Rotation of disks in their plane, rad.
  LargeVector<double> angle;
  /// Resultant of each grain without gravity, valid from Motion::collect to Motion::advance.
  /// During a sweep the loads of single pairs follow (Contacts::single_loads).
  LargeVector<Load> loads;
  /// Stiffness of the contacts, laid out like the loads. Zero outside steps that evaluate it.
  LargeVector<Load> stiffness;
  /// 1 / (skin distance of the grain)², 1/m2.
  LargeVector<double> per_leeway2;
  /// Material of each grain.
  std::vector<std::int32_t> material;
  /// Whether all grains have one material.
  bool of_one_material;
  /// Fabric of a geotextile node, -1 for soil; empty if all are soil.
  std::vector<std::int32_t> fabric;

  /// Takes the grains of a record, without their identities.
  explicit Bodies(const io::GrainsRecord& record);
  /// Returns the number of grains.
  std::size_t size() const { return grains.size(); }
  /// Returns the radius, m.
  double radius(std::size_t i) const { return grains[i].position[3]; }
  /// Returns the mass, kg.
  double mass(std::size_t i) const { return grains[i].velocity[3]; }
  /// Returns the moment of inertia, kg m2. Nodes do not rotate: theirs is infinite.
  double inertia(std::size_t i) const {
    return is_node(i) ? std::numeric_limits<double>::infinity() : gyration * mass(i) * radius(i) * radius(i);
  }

  /// Returns the fluctuation velocity, m/s, and the mass, kg.
  Lane4 velocity(std::size_t i) const {
    const Lane4& v = grains[i].velocity;
    return dimension == 2 ? Lane4{v[0], v[1], 0, v[3]} : v;
  }
  /// Returns the spin, rad/s, and the radius, m.
  Lane4 spin(std::size_t i) const {
    return dimension == 2 ? Lane4{0, 0, grains[i].velocity[2], radius(i)} : grains[i].spin;
  }
  /// Sets the velocity of a grain, m/s.
  void set_velocity(std::size_t i, const Vec3& v);
  /// Sets the spin of a grain, rad/s.
  void set_spin(std::size_t i, const Vec3& spin);

  /// Returns the force on a grain, N.
  Lane4 force(std::size_t i) const {
    const Lane4& f = loads[i].force;
    return dimension == 2 ? Lane4{f[0], f[1], 0, 0} : f;
  }
  /// Returns the torque on a grain, N m.
  Lane4 torque(std::size_t i) const { return dimension == 2 ? Lane4{0, 0, loads[i].force[2], 0} : loads[i].torque; }

  /// Returns whether a grain is a node of a geotextile.
  bool is_node(std::size_t i) const { return !fabric.empty() && fabric[i] >= 0; }
  /// Returns whether both grains are nodes of one fabric. Such nodes touch only across a periodic face.
  bool in_one_fabric(std::size_t i, std::size_t j) const { return is_node(i) && fabric[i] == fabric[j]; }
  /// Makes grains the nodes of fabrics, which do not rotate.
  void set_fabric(std::vector<std::int32_t> fabric_of);

  /// Scales the radii at constant density, and the coordinates by `stretch`. Nodes stay.
  void scale_radii(double factor, const Vec3& stretch);
  /// Returns the volume of the grains, m3 (2D: m2). Overlaps count twice.
  double solid_volume() const;
  /// Returns the largest radius, m.
  double largest_radius() const;
  /// Returns the smallest radius, m.
  double smallest_radius() const;
  /// Returns the smallest mass, kg.
  double smallest_mass() const;
  /// Returns the smallest moment of inertia without nodes, kg m2.
  double smallest_inertia() const;
  /// Returns the mass of all grains, kg.
  double total_mass() const;
  /// Returns the part of a record that Bodies lacks: the identities.
  static io::GrainsRecord identities(io::GrainsRecord record);
  /// Writes the state of the grains into a record of identities.
  void store(io::GrainsRecord& record) const;
};

}  // namespace soilweave::dem
