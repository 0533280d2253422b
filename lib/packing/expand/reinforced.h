// The reinforced part of an assembly: soil and geotextiles to be surrounded, and the grains of a block that belong to
// it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "files/records.h"

namespace soilweave::packing {

/// For the grains of a block: which ones the reinforced part has already, or which ones lie inside it.
struct Origin {
  bool cut = false;         // whether the reinforced soil was cut from this very block
  std::vector<bool> taken;  // whether the reinforced part has the grain of the block, by grain
};

/// Returns whether the soil was cut from the block, by body_id, copies and radii, which growth multiplies by one
/// factor.
bool is_cut_from(const io::Snapshot& reinforced, const io::Snapshot& block);

/// Returns the grains of the block that the reinforced part was cut from. If it was cut from another block, returns
/// those inside its geotextile.
Origin origin(const io::Snapshot& reinforced, const io::Snapshot& block);

/// Returns the soil between flat geotextiles, for which keep(grain) holds. The geotextiles are faces (yarns of family
/// 0) without sides, one fabric for each connected face.
io::Snapshot between_faces(const io::Snapshot& bag, const std::vector<bool>& keep);

/// Returns the edge lengths of the box around the bodies, m.
Vec3 extent(const io::Snapshot& state);

/// Tests whether points lie inside a closed geotextile that is star-shaped about its middle. Without one it tests
/// against the box around the centres of the soil.
class Inside {
 public:
  /// Takes the geotextiles of a state.
  explicit Inside(const io::Snapshot& reinforced);
  /// Returns whether a point lies inside.
  bool operator()(const Vec3& at) const;

 private:
  /// A node, with the outward normal of its surroundings.
  struct Node {
    Vec3 position, outwards;
  };
  std::vector<Node> nodes_;                        // nodes of closed geotextiles
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();  // box of the soil's centres
  bool any_soil_ = false;
};

}  // namespace soilweave::packing
