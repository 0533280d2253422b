// Moves several grains at a time by their forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "dem/state/bodies.h"

namespace soilweave::dem {

/// Input of a step that all grains share.
struct Push {
  /// Local damping; time step, s; Bodies::gyration.
  double damping, dt, gyration;
  /// Gravity along each axis, m/s2, in every lane.
  std::array<std::array<double, 8>, 3> gravity;
  /// Velocity gradient of the cell, 1/s.
  Mat3 gradient;
  /// Whether there is gravity, and whether the cell deforms.
  bool heavy, deforming;
  /// Whether all grains stay in the cache from step to step.
  bool in_cache;
};

/// Sums over moved grains. Grain k adds to component k modulo 4 of each row.
struct MotionTally {
  /// Twice the power, W.
  Lane4 damping{}, gravity_work{};
  /// Largest fluctuation speed, squared, m2/s2.
  double fastest2 = 0;
  /// Largest speed over skin distance (Neighbours), squared, 1/s2.
  double skin_rate2 = 0;
};

/// Arrays of grains and their data. Index i is the same grain in each.
struct MovedGrains {
  Grain* grains;
  Load* loads;
  /// Rotation of disks, rad.
  double* angle;
  /// Bodies::per_leeway2, 1/m2.
  const double* per_leeway2;
};

/// Moves the grains from `begin` to `end` and leaves their loads zero. Their number is a multiple of `at_once`.
/// Cundall's local damping (LAWS.md §4) scales each force component: by 1 - damping if it speeds the grain up,
/// by 1 + damping if it slows it down.
using MoveGrains = void (*)(const Push& push, MovedGrains of, std::size_t begin, std::size_t end, MotionTally& tally);
/// The loops of one width.
struct GrainMotion {
  /// Loops for spheres and for disks.
  MoveGrains in_space, in_plane;
  /// Number of grains moved at once.
  std::size_t at_once;
};

/// Returns the loops for eight grains with AVX-512, else for four. Both give equal bits.
GrainMotion grain_motion();
/// Returns the loops for four grains at a time.
GrainMotion grain_motion_of_four();
/// Returns the loops for eight grains at a time.
GrainMotion grain_motion_of_eight();

}  // namespace soilweave::dem
