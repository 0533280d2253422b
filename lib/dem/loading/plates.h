// Checks that the orders of a stage fit each other, its plates and its space.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/doubts.h"
#include "dem/loading/path.h"
#include "files/records.h"

namespace soilweave::dem {

/// Returns why one part cannot follow all of its orders at the same time; empty if every part can.
std::string contradiction(const std::vector<DriveGoal>& goals);

/// Plates and clamps of a scenario, with all planes.
struct Plates {
  const std::vector<RigPart>& parts;
  const io::PlanesRecord& planes;

  /// Returns why a stage of this path cannot load a space of this dimension between the plates; empty if it can.
  std::string misfit(const Path& path, int dimension) const;
  /// Returns doubts about a stage of this name: a height that is far from the plates' distance, and a load that pulls.
  std::vector<Doubt> doubts(const std::string& stage, const Path& path) const;

 private:
  /// Returns the part of this name, or nullptr.
  const RigPart* part(const std::string& name) const;
  /// Returns the distance of two plates that face each other along z, m; 0 for others.
  double distance_along_z(const RigPart& lower, const RigPart& upper) const;
};

}  // namespace soilweave::dem
