// A granular assembly in motion: grains, their contacts, the cell and the clock.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The discrete element method follows every grain. Grains are rigid. Where two overlap, a contact law turns overlap
// and slip into a force. Newton's law moves each grain by the sum of its forces:
//
//   m dv/dt = sum of f + m g,   I dw/dt = sum of torques,   and the stress is (1/V) sum of f (x) l   (Love-Weber)
//
// Central differences integrate it. Velocities live half a step before the positions (leap-frog). One step(), in order:
//
//   1  grains     velocities from forces (with local damping), then positions from velocities      grain_motion.h
//   2  cell       shape and deformation gradient from the velocity gradient                        cell.h
//   3  pairs      listed anew if a grain may have used up its skin                                 neighbours.h
//   4  contacts   overlap, slip, carried history -> law -> force and torques, per pair             contact_sweep.h
//   5  yarns      tension from their strain, on their nodes                                        yarns.h
//   6  sums       stress, work and dissipation; guards look for broken physics                     energies.h, guard.h
//   7  clock      the step stays below the least sqrt(2 m/k) of all grains, evaluated at intervals motion.h
//
// A periodic cell deforms with L: each grain moves at L x plus a fluctuation, and only fluctuations are stored.
// A test sets L (control.h, the servo), plane velocities or clamp velocities (rig.h) between steps:
//
//   Simulation simulation(packing, model, numerics);
//   for (Servo servo; !Servo::settled(goals, 3, tolerances, simulation); simulation.step())
//     servo.drive(goals, 3, simulation);
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "core/archive.h"
#include "dem/contact/model.h"
#include "dem/engine/clamp.h"
#include "dem/engine/energies.h"
#include "dem/engine/plate.h"
#include "dem/engine/step_times.h"
#include "dem/engine/yarns.h"
#include "dem/state/cell.h"
#include "files/records.h"

namespace soilweave::dem {

/// Measurements of every step. Stress is compression positive.
struct Measures {
  /// Love-Weber stress of contacts and, in a periodic cell, yarns, Pa (2D: N/m).
  Mat3 stress = Mat3::Zero();
  /// Affine stiffness of the same contacts and yarns along each axis, as last evaluated, Pa.
  Vec3 axial_stiffness = Vec3::Zero();
  /// Number of contacts.
  std::int64_t contacts = 0;
};

/// One assembly in motion.
class Simulation {
 public:
  /// Takes a state with its contacts and their history. Contacts missing there begin at zero shear.
  /// Throws DataError for overlaps above Limits::overlap, and for materials that the model lacks.
  Simulation(const io::Snapshot& state, const Model& model, const Numerics& numerics);
  /// Continues, to equal bits, from a snapshot and the numbers that archive() kept with it.
  Simulation(const io::Snapshot& state, const Model& model, const Numerics& numerics, Archive& kept);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Advances one time step. Throws PhysicsError when physics breaks.
  void step();

  /// Returns the measurements of the last step.
  const Measures& measures() const;
  /// Returns the mean resultant on grains over the mean force of contacts and taut yarns.
  /// The mean force is taken as `least` (N) if it is smaller; 0/0 is 0.
  double unbalanced_force(double least = 0) const;
  /// Returns the kinetic energy, J.
  double kinetic_energy() const;
  /// Returns the kinetic energy of the grains under some force, J: grains that float free are left out.
  double kinetic_energy_of_acted_on() const;
  /// Returns the largest overlap over the smaller radius.
  double largest_overlap() const;
  /// Returns the energies of this moment.
  Energies energies() const;
  /// Returns the length of the next step, s.
  double time_step() const;
  /// Returns the share of the stable step that dashpots leave (step_bound.h), 1 without any.
  double dashpot_share() const;
  /// Returns the stability limit from the present stiffness and the dashpots, s.
  double stability_limit();
  /// Returns the time since the start, s.
  double time() const;
  /// Returns the number of steps since the start.
  std::int64_t steps() const;

  const Cell& cell() const;
  /// Returns the cell vectors as columns, m.
  const Mat3& cell_matrix() const { return cell().matrix(); }
  /// Returns the deformation gradient since the reference.
  const Mat3& deformation_gradient() const { return cell().deformation_gradient(); }
  /// Returns the volume of the cell, m3 (2D: m2).
  double volume() const { return cell().volume(); }
  std::size_t grains() const { return bodies().size(); }
  const Bodies& bodies() const;
  /// Returns the mass of all grains, kg (2D: kg/m).
  double mass() const { return bodies().total_mass(); }
  /// Returns the volume of the grains, m3 (2D: m2). Overlaps count twice.
  double solid_volume() const { return bodies().solid_volume(); }
  /// Returns the void ratio, with overlaps counted twice as solid.
  double void_ratio() const { return volume() / solid_volume() - 1; }
  /// Returns the natural strains since the reference, -ln F_ii, compression positive, never -0.
  Vec3 strain() const { return (0.0 - deformation_gradient().diagonal().array().log()).matrix(); }
  /// Makes the present cell the reference of the strains.
  void set_reference();
  /// Sets L, 1/s, extension positive.
  void set_velocity_gradient(const Mat3& gradient);

  /// Sets the velocity of a plane, m/s.
  void set_plane_velocity(std::size_t plane, const Vec3& velocity);
  const Planes& planes() const;
  /// Returns the loads of the grains on the planes.
  std::vector<PlateLoad> plate_loads() const;
  /// Sets the velocity of a clamp, m/s.
  void set_clamp_velocity(std::size_t clamp, const Vec3& velocity);
  const std::vector<Clamp>& clamps() const;
  const YarnSums& yarns() const;

  /// Replaces friction or law parameters between stages. History stays.
  void set_model(const Model& model);
  /// Sets the local damping, 0 to 1.
  void set_damping(double damping);
  /// Scales the radii of soil at constant density, and its coordinates by `stretch`.
  void scale_radii(double factor, const Vec3& stretch = Vec3::Ones());
  /// Multiplies all fluctuation velocities and spins by `share`. The lost energy counts as damped.
  void slow_motion(double share);
  /// Changes velocities. Gained kinetic energy counts as boundary work, lost energy as damped.
  void change_velocities(const std::function<void(Bodies&)>& change);

  /// Returns state and history. A Simulation made from the snapshot alone starts its energies anew.
  io::Snapshot snapshot() const;
  /// Keeps the numbers that a snapshot lacks.
  void archive(Archive& archive) const;
  /// Returns the number of contacts, summed over the steps.
  std::int64_t contact_steps() const;
  /// Returns the sampled times of the steps.
  const StepTimes& step_times() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace soilweave::dem
