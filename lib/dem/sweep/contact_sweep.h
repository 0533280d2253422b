// One sweep over all pairs, the hot loop: motion, history, law, forces, and their sums.
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
// A chunk of grains sums its contacts one by one, and chunks are summed in order. So bits are equal for any number of
// threads and any width of the register. The sweep is compiled once per law and width, and chosen once per run:
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

/// Sums over the contacts in the step that led to the present positions.
struct SweepSums {
  /// Sum of f (x) l, N m. Divided by the volume it is the stress, compression positive.
  Mat3 force_branch = Mat3::Zero();
  /// Work on the shear, rolling and twisting springs, J.
  double tangential_work = 0;
  /// Energy lost in sliding, in rolling and twisting, and in dashpots, J.
  double frictional = 0, rolling_plastic = 0, viscous = 0;
  /// Work of moving planes on the grains, J.
  double plane_work = 0;
  /// Largest overlap, m.
  double largest_overlap = 0;
  /// Number of contacts.
  std::int64_t contacts = 0;
};

/// Energies stored in the contacts, computed only when needed.
struct StoredEnergies {
  /// Energy of each kind of spring, J.
  double normal = 0, shear = 0, rolling = 0, twisting = 0;
  /// Returns the energy of the tangential springs.
  double tangential() const { return shear + rolling + twisting; }
};

/// Parts of a simulation that a sweep uses.
struct Scene {
  /// Grains; the sweep writes only their loads.
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

/// Stiffness and damping of one contact.
struct PairStiffness {
  /// Normal stiffness, N/m; larger one of the rolling and twisting stiffnesses, N m/rad.
  double normal = 0, rotational = 0;
  /// Normal dashpot over that which damps the two grains critically, 1.
  double damping_ratio = 0;
};

/// A sweep for one law and one width of the register. Each simulation needs its own, since it keeps buffers.
class ContactSweep {
 public:
  virtual ~ContactSweep() = default;
  /// Updates every contact over a step dt, and adds forces and torques to the loads, which must be zero.
  /// The first sweep of a simulation has dt = 0, which leaves the history as it is.
  /// The result's force_branch lacks the sum of F (x) x over the grains (Motion::collected).
  /// `affine_stiffness`: if given, the sweep does the work of stiffen() too, and stores its result here.
  virtual SweepSums run(const Scene& scene, double dt, Contacts& contacts, AroundChunk& around,
                        Vec3* affine_stiffness = nullptr) = 0;
  /// Adds each contact's stiffness along the axes to Bodies::stiffness.
  /// Translation is in `force`, N/m; rotation in `torque`, N m/rad (in the plane in force[2]).
  /// Returns the sum of affine stiffness times squared branch along the axes, N m.
  virtual Vec3 stiffen(const Scene& scene, Contacts& contacts) = 0;
  /// Returns the energies stored in all contacts now.
  virtual StoredEnergies stored(const Scene& scene, Contacts& contacts) = 0;
  /// Returns the largest stiffness and damping between equal grains at a radius and an overlap, m (step_bound.h).
  /// One of the grains has a material index below `materials`, the other any material.
  virtual PairStiffness stiffness(double radius, double overlap, std::int32_t materials, int dimension) const = 0;
  /// Returns the normal force between equal grains of the first material at a radius and an overlap, m.
  virtual double normal_force(double radius, double overlap) const = 0;
  /// Returns the largest gap across which two bodies act on each other, m.
  virtual double range() const = 0;
  /// Returns the fields of history that only this law keeps.
  virtual std::span<const HistoryField> own_history() const = 0;
};

/// Makes the sweep for a model: eight contacts at a time with AVX-512, else four. Both give equal bits.
std::unique_ptr<ContactSweep> make_contact_sweep(const Model& model);
/// Makes a sweep of four contacts at a time.
std::unique_ptr<ContactSweep> make_contact_sweep_of_four(const Model& model);
/// Makes a sweep of eight contacts at a time.
std::unique_ptr<ContactSweep> make_contact_sweep_of_eight(const Model& model);

}  // namespace soilweave::dem
