// From forces to motion: leap-frog with local damping, and the stable time step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"
#include "dem/sweep/grain_motion.h"

namespace soilweave::dem {

/// Sums of a pass over the grains.
struct MotionSums {
  /// Energy taken by local damping in this step, J.
  double damping = 0;
  /// Work of gravity in this step, J.
  double gravity_work = 0;
  /// Largest fluctuation speed, m/s.
  double fastest = 0;
  /// Largest speed over skin distance (Neighbours), 1/s.
  double skin_rate = 0;
};

/// Passes over the grains, chunk by chunk (contacts.h).
/// Different threads may work on different chunks. Sums are kept, so that stepping allocates nothing.
class Motion {
 public:
  /// Prepares the passes. `how`: loops over the grains, for one register width.
  Motion(std::size_t grains, int threads, const GrainMotion& how = grain_motion());

  /// Sets the data of the next step.
  void set_out(const Cell& cell, const Vec3& gravity, double damping, double dt, const Bodies& bodies);
  /// Moves the grains of a chunk. Leaves their loads zero.
  void advance(std::size_t chunk, Bodies& bodies);
  /// Moves all grains, chunk by chunk.
  void advance_all(Bodies& bodies);
  /// Returns the sums over all chunks since set_out().
  MotionSums advanced() const;
  /// Returns a bound on the speed that any grain can gain in the coming step, m/s.
  /// It is infinite before forces were collected. Call it before anything moves.
  double gain_bound(double smallest_mass) const;

  /// Adds the loads of single pairs to those of the chunk's grains, in a fixed order.
  void collect(std::size_t chunk, const Contacts& contacts, Bodies& bodies);
  /// Returns the sum of force (x) position over the grains, N m.
  Mat3 collected() const;

  /// Returns the sum over the grains of |resultant|, gravity included, N.
  double resultants(const Vec3& gravity, const Bodies& bodies);

  /// Returns the stability limit, s, infinite without contacts: the least sqrt(2 m/k) over grains and axes.
  /// It holds for translation and rotation (Chareyre & Villard 2005, Eq. 2.9; LAWS.md §8).
  /// It reads the stiffnesses that ContactSweep::stiffen has set, and resets them to zero.
  double stable_time_step(const Contacts& contacts, Bodies& bodies);

 private:
  /// Sums of one chunk over its collected loads.
  struct Collected {
    /// Rows: force times x, y, z of the position.
    Lane4 virial[3] = {};
    /// Largest square of each force component, N2.
    Lane4 force{};
  };
  template <int dimension>
  static Collected collect(std::size_t chunk, const Contacts& contacts, Bodies& bodies);
  template <class Pass>
  void pass(const Pass& over) const;

  /// Loops over the grains, for one register width.
  GrainMotion how_;
  /// Number of threads.
  int threads_;
  /// Data of the next step.
  Push push_{};
  /// Sums of the moves, by chunk.
  std::vector<MotionTally> moved_;
  /// Sums of the loads, by chunk.
  std::vector<Collected> collected_;
  /// Sums of other passes, by chunk.
  std::vector<double> partial_;
};

/// Kinetic energies around a change of all velocities.
struct Slowed {
  /// Kinetic energy before and after the change, as kinetic_energy() returns it, J.
  double energy_before = 0, energy_after = 0;

  void operator+=(const Slowed& other) { energy_before += other.energy_before, energy_after += other.energy_after; }
};
/// Multiplies all fluctuation velocities and spins by `share`. Returns the kinetic energy before and after.
Slowed slow(Bodies& bodies, double share, const Vec3& gravity, double dt, int threads);
/// Returns the kinetic energy of the fluctuation, J, with velocities advanced by half a step.
double kinetic_energy(const Bodies& bodies, const Vec3& gravity, double dt, int threads);
/// Returns the kinetic energy of the grains under some force, J.
/// A grain that floats free without gravity is never slowed, even in an assembly at rest.
double kinetic_energy_of_acted_on(const Bodies& bodies, const Vec3& gravity, double dt, int threads);

}  // namespace soilweave::dem
