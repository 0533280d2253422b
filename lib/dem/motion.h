// From forces to motion: per-grain sums in fixed order, leap-frog with local damping, the stable time step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/bodies.h"
#include "dem/cell.h"
#include "dem/contacts.h"

namespace soilweave::dem {

/// What a pass over the grains measures.
struct MotionSums {
  double damping = 0;       // J, taken by local damping in this step
  double gravity_work = 0;  // J, in this step
  double fastest = 0;       // m/s, largest fluctuation speed
};

/// Passes over the grains; keeps the partial sums of its chunks from call to call, so that stepping allocates nothing.
class Motion {
 public:
  Motion(std::size_t grains, int threads);

  /// Adds the loads of single pairs to those of their grains, in a fixed order. Returns the sum of force (x) position,
  /// N m.
  Mat3 gather(const Contacts& contacts, Bodies& bodies);

  /// Sum over the grains of |resultant|, gravity included, N.
  double resultants(const Vec3& gravity, const Bodies& bodies);

  /// One step: velocities by the forces, damped by Cundall's local damping (dem-laws §4: each component's force is
  /// scaled by 1 -+ damping as it speeds up or slows down), positions by the new velocities and the cell's affine
  /// motion. Uses the loads of the grains up: they are left zero.
  MotionSums advance(const Cell& cell, const Vec3& gravity, double damping, double dt, Bodies& bodies);

  /// Stability limit from the stiffnesses in the loads (ContactSweep::stiffen), which are left zero, s: sqrt(2) times
  /// the least sqrt(m/k) over grains and axes, translation and rotation (Chareyre & Villard 2005, Eq. 2.9; dem-laws
  /// §8). Infinite without contacts.
  double stable_time_step(const Contacts& contacts, Bodies& bodies);

 private:
  struct Partial {
    Lane4 damping{}, gravity_work{};
    Lane4 virial[3] = {};  // rows: force times x, y, z of the position
    Lane4 largest{};
    double sum = 0;
  };
  template <bool planar>
  static void advance(const struct Push& push, Grain* grains, Load* loads, Partial& partial);
  template <class Body>
  void chunked(std::size_t grains, const Body& body);

  int threads_;
  std::vector<Partial> partial_;
};

/// Kinetic energy of the fluctuation at the time of the forces, J: half a step of the present forces added.
double kinetic_energy(const Bodies& bodies, const Vec3& gravity, double dt);

}  // namespace soilweave::dem
