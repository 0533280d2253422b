// Rigid planes as contact partners of grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/tensor.h"
#include "files/records.h"

namespace soilweave::dem {

/// Grains that touch a plane; numbers as in files.
enum class Partners : std::int32_t { all = 0, soil = 1, fabric = 2 };

/// One plane.
struct Plane {
  /// Point on the plane, m; unit normal towards the grains; velocity, m/s.
  Vec3 point, normal, velocity;
  /// Material of the plane.
  std::int32_t material;
  /// Grains that touch it.
  Partners partners = Partners::all;

  /// Returns whether the plane acts on a node, or on a grain of soil.
  bool touches(bool node) const { return partners == Partners::all || (partners == Partners::fabric) == node; }
};

/// All planes of a simulation. Their velocities are constant in a step.
struct Planes {
  /// Planes in the order of files.
  std::vector<Plane> all;

  Planes() = default;
  /// Takes the planes of a record.
  explicit Planes(const io::PlanesRecord& record);
  /// Moves all planes over a step.
  void advance(double dt) {
    for (Plane& p : all) p.point += dt * p.velocity;
  }
  /// Returns the planes as files hold them.
  io::PlanesRecord record() const;
};

/// Returns the index of the plane from the negative index of a contact's second body.
inline std::size_t plane_number(std::int32_t second) { return static_cast<std::size_t>(-1 - second); }

}  // namespace soilweave::dem
