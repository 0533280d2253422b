// Changes to the motion of the grains as the ways to stations begin and end, and while stations wait for rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/archive.h"
#include "dem/rig.h"
#include "dem/scenario.h"
#include "dem/swing.h"

namespace soilweave::dem {

class Way {
 public:
  /// The way of a new stage has no way before it.
  void begin_stage();
  /// Before a step on the way to a station, or while it waits for rest: a way that begins lays the homogeneous field of
  /// velocity over the grains, one that ends takes the mean field out of them, where the stage asks for it.
  void before_step(const Stage& stage, bool waiting, const std::vector<DriveGoal>& goals, double pace, const Rig& rig,
                   Simulation& simulation);
  /// After that step: while a station waits, a drag slows the grains.
  void after_step(Simulation& simulation);
  /// Steps that stations waited for rest, since the run began.
  std::int64_t waited() const { return waited_; }
  void archive(Archive& archive);

 private:
  bool waiting_ = false;
  bool laid_ = false;             // the field of the way that the grains are on
  Mat3 gradient_ = Mat3::Zero();  // 1/s, of the grains as the way before in this stage ended
  double drag_ = 0;               // 1/s, while this station waits, where it is given
  bool critical_ = false;         // where it is not, but follows the swing
  Swing swing_;
  std::int64_t waited_ = 0;
};

}  // namespace soilweave::dem
