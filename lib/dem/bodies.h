// Grains as flat arrays of rows: a vector and the scalar used with it side by side, one aligned load each.
// Velocities are fluctuations about the cell's affine motion, half a step behind the positions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/v3.h"
#include "io/records.h"

namespace soilweave::dem {

/// Of a sphere, m3; of a disk, m2.
double grain_volume(int dimension, double radius);

struct Bodies {
  int dimension = 3;
  double gyration;                 // moment of inertia over mass and squared radius
  std::vector<Lane4> position;     // x, y, z, m; radius, m
  std::vector<Lane4> velocity;     // m/s; mass, kg
  std::vector<Lane4> spin;         // rad/s; radius, m, once more
  std::vector<Lane4> force;        // N, resultant of the contacts, gravity apart; 0
  std::vector<Lane4> torque;       // N m; 0
  std::vector<Lane4> orientation;  // quaternion, in the order w x y z
  std::vector<std::int32_t> material;
  std::vector<std::int32_t> fabric;  // of a node of a geotextile, -1 of soil; empty where all are soil

  explicit Bodies(const io::GrainsRecord& record);
  std::size_t size() const { return position.size(); }
  double radius(std::size_t i) const { return position[i][3]; }
  double mass(std::size_t i) const { return velocity[i][3]; }
  /// kg m2; nodes of geotextiles do not rotate.
  double inertia(std::size_t i) const {
    return is_node(i) ? std::numeric_limits<double>::infinity() : gyration * mass(i) * radius(i) * radius(i);
  }

  bool is_node(std::size_t i) const { return !fabric.empty() && fabric[i] >= 0; }
  /// Nodes of one fabric are held together by yarns and do not touch.
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
  double total_mass() const;
  /// Positions, velocities, orientations, radii and masses back into a record that already holds the identities.
  void store(io::GrainsRecord& record) const;
};

}  // namespace soilweave::dem
