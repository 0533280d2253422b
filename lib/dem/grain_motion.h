// How forces move grains in a step, several grains at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "dem/bodies.h"

namespace soilweave::dem {

/// What grains are moved by in a step.
struct Push {
  double damping, dt, gyration;
  std::array<std::array<double, 8>, 3> gravity;  // along each axis, for each of the grains taken at a time, m/s2
  Mat3 gradient;                                 // of the cell, 1/s
  bool heavy, deforming;
  bool in_cache;  // all grains are from step to step
};

/// What moving grains sums up: four sums side by side, grain k adds to number k modulo 4.
struct MotionTally {
  Lane4 damping{}, gravity_work{};  // twice the power, W
  double fastest2 = 0;              // m2/s2
  double haste2 = 0;                // largest speed over leeway (Neighbours), 1/s2
};

/// Grains and what belongs to them, side by side.
struct MovedGrains {
  Grain* grains;
  Load* loads;
  double* angle;  // of disks
  const double* per_leeway2;
};

/// Moves the grains from `begin` to `end`, whose number is a multiple of `at_once`: velocities by the forces, damped by
/// Cundall's local damping (dem-laws §4: each component's force is scaled by 1 -+ damping as it speeds up or slows
/// down), positions by the new velocities and the cell's affine motion. Uses their loads up: they are left zero.
using MoveGrains = void (*)(const Push& push, MovedGrains of, std::size_t begin, std::size_t end, MotionTally& tally);
struct GrainMotion {
  MoveGrains in_space, in_plane;
  std::size_t at_once;
};

/// Eight at a time where the processor has AVX-512, else four: the bits are the same.
GrainMotion grain_motion();
GrainMotion grain_motion_of_four();
GrainMotion grain_motion_of_eight();

}  // namespace soilweave::dem
