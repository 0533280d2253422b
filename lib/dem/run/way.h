// Changes of the grains' motion at the start and end of the loading to a station, and while a station waits for rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/archive.h"
#include "dem/loading/rig.h"
#include "dem/loading/swing.h"
#include "dem/run/scenario.h"

namespace soilweave::dem {

/// Changes of the grains' velocities in one run.
class Way {
 public:
  /// Begins a stage. Its first loading starts without the gradient of an earlier loading.
  void begin_stage();
  /// Adds a homogeneous field of velocity when the loading begins and removes it at the end, if the stage asks for it.
  /// Call it before each step.
  void before_step(const Stage& stage, bool waiting, const std::vector<DriveGoal>& goals, double pace, const Rig& rig,
                   Simulation& simulation);
  /// Slows the grains by a drag while a station waits. Call it after each step.
  void after_step(Simulation& simulation);
  /// Returns the number of steps of all waits in the run.
  std::int64_t waited() const { return waited_; }
  /// Counts steps in which only the kinetic energy was above its limit.
  void wait_for_energy(std::int64_t steps) { waited_for_energy_ += steps; }
  /// Returns the number of steps that wait_for_energy() has counted since the run began.
  std::int64_t waited_for_energy() const { return waited_for_energy_; }
  /// Keeps or restores the state between steps.
  void archive(Archive& archive);

 private:
  /// Whether the station waits for rest.
  bool waiting_ = false;
  /// Whether the homogeneous field of the present loading has been added to the grains.
  bool laid_ = false;
  /// Best-fit velocity gradient of the grains when the last loading of this stage ended, 1/s.
  Mat3 gradient_ = Mat3::Zero();
  /// Drag while this station waits, if prescribed, 1/s.
  double drag_ = 0;
  /// Whether the drag is swing_.critical_drag() instead.
  bool critical_ = false;
  /// Estimator of the swing while the station waits.
  Swing swing_;
  std::int64_t waited_ = 0, waited_for_energy_ = 0;
};

}  // namespace soilweave::dem
