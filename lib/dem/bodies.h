// Grains as flat arrays. Velocities are fluctuations about the cell's affine motion, half a step behind the positions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/lanes.h"
#include "core/tensor.h"
#include "io/records.h"

namespace soilweave::dem {

/// Of a sphere, m3; of a disk, m2.
double grain_volume(int dimension, double radius);

struct Bodies {
  int dimension = 3;
  std::vector<V3<double>> position;          // m
  std::vector<V3<double>> velocity;          // m/s
  std::vector<V3<double>> angular_velocity;  // rad/s
  std::vector<V3<double>> force;             // N, resultant of the contacts, gravity apart
  std::vector<V3<double>> torque;            // N m
  std::vector<double> radius, mass, inertia;
  std::vector<std::int32_t> material;
  std::vector<Vec4> orientation;

  explicit Bodies(const io::GrainsRecord& record);
  std::size_t size() const { return position.size(); }

  /// Radii times factor at constant density; inertia follows.
  void scale_radii(double factor);
  /// Volume of the grains, overlaps counted twice: m3 (2D: m2).
  double solid_volume() const;
  double largest_radius() const;
  double smallest_radius() const;
  /// Positions, velocities, orientations, radii and masses back into a record that already holds the identities.
  void store(io::GrainsRecord& record) const;
};

}  // namespace soilweave::dem
