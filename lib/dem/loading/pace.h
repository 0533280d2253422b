// Loading speed of plates and cells, which slows down while the unbalanced force exceeds its limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/archive.h"

namespace soilweave::dem {

/// A loading speed that adapts to the unbalanced force. It starts at a hundredth of the prescribed speed.
class Pace {
 public:
  /// Estimates from the number of grains how many steps a wave takes to cross the assembly.
  Pace(std::size_t grains, int dimension);

  /// Starts again at the least speed.
  void begin_stage();
  /// Adapts the speed so that the unbalanced force stays near `wanted`.
  /// unbalanced: the present ratio. steps: number of steps since the last call.
  void follow(double unbalanced, double wanted, std::int64_t steps);
  /// Returns the share of the prescribed speeds and rates, in (0, 1].
  double share() const { return share_; }
  /// Keeps or restores the present share.
  void archive(Archive& archive);

 private:
  /// Number of steps in which a wave crosses the assembly.
  double crossing_;
  /// Present share of the prescribed speed.
  double share_;
  /// Whether the unbalanced force came near the wanted one in this stage.
  bool found_ = false;
};

}  // namespace soilweave::dem
