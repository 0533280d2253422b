// The reinforced part of an assembly: soil and geotextiles that are to be surrounded, and what of a block belongs to
// it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/records.h"

namespace soilweave::packing {

/// Where the grains of a block lie: which of them the reinforced part has already, and which lie inside it.
struct Origin {
  bool cut = false;         // the reinforced soil was cut from this very block
  std::vector<bool> taken;  // by grain of the block
};

/// Whether the soil was cut from the block: by numbers, copies and radii, which growth multiplies by one factor.
bool is_cut_from(const io::Snapshot& reinforced, const io::Snapshot& block);

/// Takes the grains of the block that the reinforced part was cut from; where it was cut from another one, those that
/// lie inside its geotextile.
Origin origin(const io::Snapshot& reinforced, const io::Snapshot& block);

/// The soil between flat geotextiles: the faces of the geotextiles (yarns of family 0), one fabric for each that hangs
/// together, without the sides; soil for which keep(grain) holds.
io::Snapshot between_faces(const io::Snapshot& bag, const std::vector<bool>& keep);

/// Lengths of the box around the bodies, m.
Vec3 extent(const io::Snapshot& state);

/// Whether points lie inside a closed geotextile, all of which is seen from its middle; where none is closed, in the
/// box around the centres of the soil.
class Inside {
 public:
  explicit Inside(const io::Snapshot& reinforced);
  bool operator()(const Vec3& at) const;

 private:
  struct Node {
    Vec3 position, outwards;
  };
  std::vector<Node> nodes_;                        // of closed geotextiles
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();  // of the soil's centres
  bool any_soil_ = false;
};

}  // namespace soilweave::packing
