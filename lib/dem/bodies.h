// Grains as flat arrays of rows: a vector and the scalar used with it side by side, one aligned load each.
// Velocities are fluctuations about the cell's affine motion, half a step behind the positions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

  explicit Bodies(const io::GrainsRecord& record);
  std::size_t size() const { return position.size(); }
  double radius(std::size_t i) const { return position[i][3]; }
  double mass(std::size_t i) const { return velocity[i][3]; }
  double inertia(std::size_t i) const { return gyration * mass(i) * radius(i) * radius(i); }  // kg m2

  /// Radii times factor at constant density; inertia follows.
  void scale_radii(double factor);
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
