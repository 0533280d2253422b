// Moves grains by their forces over one step, several grains at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "dem/state/bodies.h"

namespace soilweave::dem {

/// Input of a step that all grains share.
struct Push {
  double damping, dt, gyration;
  /// Gravity along each axis, m/s2, repeated for the grains of a register.
  std::array<std::array<double, 8>, 3> gravity;
  /// Velocity gradient of the cell, 1/s.
  Mat3 gradient;
  bool heavy, deforming;
  /// Whether all grains stay in the cache from step to step.
  bool in_cache;
};

/// Sums over moved grains. Each is four sums side by side: grain k adds to number k modulo 4.
struct MotionTally {
  /// Twice the power, W.
  Lane4 damping{}, gravity_work{};
  double fastest2 = 0;  // m2/s2
  /// Largest speed over skin distance (Neighbours), squared, 1/s2.
  double skin_rate2 = 0;
};

/// Arrays of grains and of their data, with equal indices.
struct MovedGrains {
  Grain* grains;
  Load* loads;
  /// Rotation of disks, rad.
  double* angle;
  const double* per_leeway2;
};

/// Moves the grains from `begin` to `end`, whose number is a multiple of `at_once`. Forces change the velocities, with
/// Cundall's local damping (LAWS.md §4): each force component is scaled by 1 - damping if it speeds the grain up, 1 +
/// damping if it slows it down. The new velocities and the cell's affine motion change the positions. Leaves the loads
/// zero.
using MoveGrains = void (*)(const Push& push, MovedGrains of, std::size_t begin, std::size_t end, MotionTally& tally);
/// The loops of one width: for spheres, for disks, and the number of grains that they take at a time.
struct GrainMotion {
  MoveGrains in_space, in_plane;
  /// Number of grains moved at once.
  std::size_t at_once;
};

/// Returns the loop for eight grains at a time if the processor has AVX-512, else for four. The bits are equal.
GrainMotion grain_motion();
GrainMotion grain_motion_of_four();
GrainMotion grain_motion_of_eight();

}  // namespace soilweave::dem
