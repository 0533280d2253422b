// One sweep over all pairs: motion of the contact, carried history, law, forces, and their sums. The hot loop.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sweep visits each pair of the neighbour list once per step, and most of them touch. For a pair it computes
//
//   overlap  u = r1 + r2 - |x2 - x1|,   normal n from grain 1 to grain 2
//   slip     the tangential part of the relative surface velocity, times dt      contact_kinematics.h
//   history  last step's shear force and moments, rotated with the pair          transport.h
//   law      normal force from u; shear force += -ks slip, cut at mu Fn; moments laws/
//   action   +f and its torque on grain 2, -f on grain 1                         contact_action.h
//
// Picture the pairs as lanes of a road: a register holds four or eight of them, and the same instruction serves all.
// No lane may branch on its own. A pair that does not touch computes along and is masked to zero.
//
// The sums must not depend on how the work is divided. So grains are cut into chunks, a chunk sums its contacts one by
// one, and chunks are summed in order: equal bits for any number of threads and any width of the register.
// The sweep is compiled once per law and width, and chosen once per run:
//
//   const std::unique_ptr<ContactSweep> sweep = make_contact_sweep(model);
//   const SweepSums sums = sweep->run({bodies, cell, planes}, dt, contacts, passes);
//   const Mat3 stress = (sums.force_branch + motion.collected()) / cell.volume();
#pragma once

#include <memory>
#include <span>

#include "dem/contact/contacts.h"
#include "dem/contact/model.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"
#include "dem/state/plane.h"

namespace soilweave::dem {

/// Sums over the contacts in a step. Work is that of the step that led to the present positions, J.
struct SweepSums {
  /// Sum of f (x) l, N m; over the volume: stress, compression positive.
  Mat3 force_branch = Mat3::Zero();
  /// Work on the shear, rolling and twisting springs.
  double tangential_work = 0;
  /// Energy lost in sliding, in rolling and twisting, and in dashpots.
  double frictional = 0, rolling_plastic = 0, viscous = 0;
  /// Work of moving planes on the grains.
  double plane_work = 0;
  /// Largest overlap, m.
  double largest_overlap = 0;
  /// Number of contacts.
  std::int64_t contacts = 0;
};

/// Energies stored in the contacts, J, computed only when needed.
struct StoredEnergies {
  /// Energy by spring.
  double normal = 0, shear = 0, rolling = 0, twisting = 0;
  /// Returns the energy of the tangential springs.
  double tangential() const { return shear + rolling + twisting; }
};

/// Parts of a simulation that a sweep uses. It writes only the loads of the bodies.
struct Scene {
  /// Grains, whose loads the sweep writes.
  Bodies& bodies;
  /// Periodic cell.
  const Cell& cell;
  /// Rigid planes.
  const Planes& planes;
};

/// Further work of a step on the grains of a chunk (ChunkPlan). Called once per chunk, by several threads.
class AroundChunk {
 public:
  virtual ~AroundChunk() = default;
  /// Called before any pair of the chunk's grains is swept.
  virtual void before(std::size_t chunk) = 0;
  /// Called after all these pairs are swept.
  virtual void after(std::size_t chunk) = 0;
};

/// Stiffness of one contact: normal, N/m; the larger one of rolling and (in space) twisting, N m/rad.
struct PairStiffness {
  double normal = 0, rotational = 0;
};

/// A sweep for one law and one width of the register. An object keeps buffers, so one simulation needs one.
class ContactSweep {
 public:
  virtual ~ContactSweep() = default;
  /// Updates every contact over a step dt that led to the present positions, and adds forces and torques to the loads,
  /// which must be zero. dt = 0 leaves positions and history as they are (first sweep of a simulation). force_branch
  /// lacks the sum of F (x) x over the grains, which Motion::collected returns. affine_stiffness: if given, receives
  /// the result of stiffen(), whose work is then done too.
  virtual SweepSums run(const Scene& scene, double dt, Contacts& contacts, AroundChunk& around,
                        Vec3* affine_stiffness = nullptr) = 0;
  /// Adds each contact's stiffness to that of its grains, along the axes x, y, z: for translation in `force`, N/m, for
  /// rotation in `torque`, N m/rad (in the plane the third component of `force`). Changes nothing else. Returns the
  /// affine stiffness times squared branch along the axes, summed over contacts, N m.
  virtual Vec3 stiffen(const Scene& scene, Contacts& contacts) = 0;
  /// Returns the energies stored in all contacts now.
  virtual StoredEnergies stored(const Scene& scene, Contacts& contacts) = 0;
  /// Returns the largest stiffness between equal grains, one of a material below `materials`, the other of any
  /// material, at the given radius and overlap, m. It bounds the step before contacts form (step_bound.h).
  virtual PairStiffness stiffness(double radius, double overlap, std::int32_t materials, int dimension) const = 0;
  /// Returns the normal force between two equal grains of the first material, N, at the given radius and overlap, m.
  virtual double normal_force(double radius, double overlap) const = 0;
  /// Returns the largest gap across which two bodies act on each other, m; 0 for a law of contact alone.
  virtual double range() const = 0;
  /// Returns the fields of history that only this law keeps.
  virtual std::span<const HistoryField> own_history() const = 0;
};

/// Makes the sweep for the law and materials of a model: eight contacts at a time if the processor has AVX-512, else
/// four. The bits are equal.
std::unique_ptr<ContactSweep> make_contact_sweep(const Model& model);
/// Makes a sweep of four contacts at a time.
std::unique_ptr<ContactSweep> make_contact_sweep_of_four(const Model& model);
/// Makes a sweep of eight contacts at a time.
std::unique_ptr<ContactSweep> make_contact_sweep_of_eight(const Model& model);

}  // namespace soilweave::dem
