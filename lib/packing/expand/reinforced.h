// The part of an assembly that is to be surrounded: soil and geotextiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "files/records.h"

namespace soilweave::packing {

/// Grains of a block that belong to the reinforced part or lie inside it.
struct Origin {
  /// Whether the reinforced soil was cut from this block.
  bool cut = false;
  /// Whether each grain of the block belongs to the part or lies inside it.
  std::vector<bool> taken;
};

/// Returns whether the soil was cut from the block: body_id and copies agree, radii up to one factor.
bool is_cut_from(const io::Snapshot& reinforced, const io::Snapshot& block);

/// Returns the grains of the block that the part was cut from. For another block, returns those inside its geotextile.
Origin origin(const io::Snapshot& reinforced, const io::Snapshot& block);

/// Returns the soil between flat geotextiles for which keep(grain) holds. The geotextiles are faces (yarns of family 0)
/// without sides. Each connected face is one fabric.
io::Snapshot between_faces(const io::Snapshot& bag, const std::vector<bool>& keep);

/// Returns the edge lengths of the box around the bodies, m.
Vec3 extent(const io::Snapshot& state);

/// Tests whether points lie inside a closed geotextile, star-shaped about its middle. Without one it tests against the
/// box of the soil's centres.
class Inside {
 public:
  /// Takes the geotextiles of a state.
  explicit Inside(const io::Snapshot& reinforced);
  /// Returns whether a point lies inside.
  bool operator()(const Vec3& at) const;

 private:
  /// A node.
  struct Node {
    /// Centre, and outward normal of the fabric there.
    Vec3 position, outwards;
  };
  /// Nodes of closed geotextiles.
  std::vector<Node> nodes_;
  /// Box of the soil's centres.
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
  bool any_soil_ = false;
};

}  // namespace soilweave::packing
