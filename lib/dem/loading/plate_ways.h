// Follows how far the stages of a run move plates.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "dem/loading/path.h"
#include "files/records.h"

namespace soilweave::dem {

/// Distances of facing planes, stage after stage, as prescribed displacements change them. Motion under loads is not
/// foreseen.
class PlateWays {
 public:
  /// Takes the planes and grains at the start. `overlap`: largest overlap of two grains over the radius.
  PlateWays(const io::Snapshot& state, std::vector<RigPart> parts, double overlap);

  /// Moves the plates along a path. Returns why they cannot follow, or an empty text if they can.
  /// Two facing planes may not come closer than the diameter of the largest grain that touches both.
  /// They may compress a single layer of grains as far as grains may overlap.
  std::string follow(const Path& path);

 private:
  /// Two planes that face each other.
  struct Facing {
    std::size_t first, second;
    /// Unit normal of the first plane, towards the second.
    Vec3 across;
    /// Distance at the start, and the largest diameter of the grains that touch both, m.
    double distance, diameter;
  };
  /// Returns the name of the plane in quotes, or its number.
  std::string name_of(std::size_t plane) const;
  /// Adds the prescribed displacements of these orders to those of the planes.
  void move(const std::vector<DriveGoal>& orders);
  /// Returns the least allowed distance of two planes, m.
  double least(const Facing& pair) const;

  std::vector<RigPart> parts_;
  double overlap_;
  std::vector<Facing> pairs_;
  /// Displacement of each plane since the start, m.
  std::vector<Vec3> displacement_;
};

}  // namespace soilweave::dem
