// How fast what is moved or strained by a given way goes: as fast as the grains follow, no faster than it is given.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/archive.h"

namespace soilweave::dem {

class Pace {
 public:
  /// Of so many grains in so many dimensions, which say how many steps a wave takes across them.
  Pace(std::size_t grains, int dimension);

  /// Starts slowly, and finds how fast it may go, anew.
  void begin_stage();
  /// Keeps the unbalanced force (mean resultant over mean contact force, as it is after so many steps more) near the
  /// wanted one.
  void follow(double unbalanced, double wanted, std::int64_t steps);
  /// Of the given speeds and rates, in (0, 1].
  double share() const { return share_; }
  void archive(Archive& archive);

 private:
  double crossing_;  // steps of a wave across the grains
  double share_;
  bool found_ = false;  // a good part of the wanted unbalanced force, since the stage began
};

}  // namespace soilweave::dem
