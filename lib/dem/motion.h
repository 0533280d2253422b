// From forces to motion: per-grain sums in fixed order, leap-frog with local damping, the stable time step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/bodies.h"
#include "dem/cell.h"
#include "dem/contacts.h"
#include "dem/grain_motion.h"

namespace soilweave::dem {

/// What a pass over the grains measures.
struct MotionSums {
  double damping = 0;       // J, taken by local damping in this step
  double gravity_work = 0;  // J, in this step
  double fastest = 0;       // m/s, largest fluctuation speed
  double haste = 0;         // 1/s, largest speed over leeway (Neighbours)
};

/// Passes over the grains, chunk by chunk (contacts.h); keeps the sums of the chunks from call to call, so that
/// stepping allocates nothing. Different threads may be at different chunks.
class Motion {
 public:
  Motion(std::size_t grains, int threads, const GrainMotion& how = grain_motion());

  /// Says by what the next step moves the grains.
  void set_out(const Cell& cell, const Vec3& gravity, double damping, double dt, const Bodies& bodies);
  /// Moves the grains of a chunk. Uses their loads up: they are left zero.
  void advance(std::size_t chunk, Bodies& bodies);
  void advance_all(Bodies& bodies);
  MotionSums advanced() const;
  /// No grain will gain more speed than this in the step set out for, m/s, by the forces as they were collected;
  /// infinite before they were. To be asked before anything moves.
  double gain_bound(double smallest_mass) const;

  /// Adds the loads of single pairs to those of the chunk's grains, in a fixed order.
  void collect(std::size_t chunk, const Contacts& contacts, Bodies& bodies);
  /// Sum of force (x) position over the grains, N m.
  Mat3 collected() const;

  /// Sum over the grains of |resultant|, gravity included, N.
  double resultants(const Vec3& gravity, const Bodies& bodies);

  /// Stability limit from the grains' stiffnesses (ContactSweep::stiffen), which are left zero, s: sqrt(2) times the
  /// least sqrt(m/k) over grains and axes, translation and rotation (Chareyre & Villard 2005, Eq. 2.9; dem-laws §8).
  /// Infinite without contacts.
  double stable_time_step(const Contacts& contacts, Bodies& bodies);

 private:
  struct Collected {
    Lane4 virial[3] = {};  // rows: force times x, y, z of the position
    Lane4 force{};         // the largest of each component, N, squared
  };
  template <int dimension>
  static Collected collect(std::size_t chunk, const Contacts& contacts, Bodies& bodies);
  template <class Pass>
  void pass(const Pass& over) const;

  GrainMotion how_;
  int threads_;
  Push push_{};
  std::vector<MotionTally> moved_;
  std::vector<Collected> collected_;
  std::vector<double> partial_;  // of other passes, by chunk
};

struct Slowed {
  double energy_before = 0, energy_after = 0;  // J, kinetic, as below

  void operator+=(const Slowed& other) { energy_before += other.energy_before, energy_after += other.energy_after; }
};
/// Of fluctuation velocities and spins this share is left.
Slowed slow(Bodies& bodies, double share, const Vec3& gravity, double dt, int threads);
/// Kinetic energy of the fluctuation at the time of the forces, J: half a step of the present forces added.
double kinetic_energy(const Bodies& bodies, const Vec3& gravity, double dt, int threads);
/// The same of the grains that something acts on. What floats free without gravity is slowed by nothing, and bears
/// nothing: an assembly at rest may hold any number of such grains.
double kinetic_energy_of_acted_on(const Bodies& bodies, const Vec3& gravity, double dt, int threads);

}  // namespace soilweave::dem
