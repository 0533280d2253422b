// One sweep over all candidate pairs: kinematics, memory transport, law, forces, and the sums that come with them.
// The hot loop of the engine; compiled once per law, chosen once per run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "dem/bodies.h"
#include "dem/cell.h"
#include "dem/contacts.h"
#include "dem/model.h"
#include "dem/plane.h"

namespace soilweave::dem {

/// Sums over the contacts that a step needs. Work, J, is of the step that led to the present positions.
struct SweepSums {
  Mat3 force_branch = Mat3::Zero();  // sum of f (x) l, N m; over the volume: the stress, compression positive
  double tangential_work = 0;        // done on the shear, rolling and twisting springs
  double frictional = 0, rolling_plastic = 0, viscous = 0;
  double plane_work = 0;       // done on the grains by moving planes
  double largest_overlap = 0;  // m
  std::int64_t contacts = 0;
};

/// What is stored in the contacts, J, looked at now and then.
struct StoredEnergies {
  double normal = 0, shear = 0, rolling = 0, twisting = 0;
  double tangential() const { return shear + rolling + twisting; }
};

/// What a sweep sees of a simulation; of the bodies it writes the loads.
struct Scene {
  Bodies& bodies;
  const Cell& cell;
  const Planes& planes;
};

/// What else a step does with the grains of a chunk, done by the thread that sweeps their pairs while they lie in its
/// cache (ChunkPlan). Called once for each chunk, by several threads.
class AroundChunk {
 public:
  virtual ~AroundChunk() = default;
  virtual void before(std::size_t chunk) = 0;  // no pair has been swept that one of the chunk's grains belongs to
  virtual void after(std::size_t chunk) = 0;   // all have
};

/// Stiffnesses of one contact: normal, N/m, and the larger one of rolling and, in space, twisting, N m/rad.
struct PairStiffness {
  double normal = 0, rotational = 0;
};

class ContactSweep {
 public:
  virtual ~ContactSweep() = default;
  /// Updates every pair's contact over a step dt that led to the present positions and adds what it does to its grains
  /// to the loads, zero before; dt = 0: positions unmoved, memory as it is (the first sweep of a simulation). What
  /// force_branch lacks is the sum of F (x) x over the grains: Motion::collected has it. affine_stiffness: where given,
  /// also does what `stiffen` does, and this is what it returns.
  virtual SweepSums run(const Scene& scene, double dt, Contacts& contacts, AroundChunk& around,
                        Vec3* affine_stiffness = nullptr) = 0;
  /// Adds the stiffness that each contact gives its grains to theirs: about the axes x, y, z against translation in
  /// `force`, N/m, and against rotation in `torque`, N m/rad; in the plane that one is the third part of the force.
  /// Changes nothing else. Returns the affine stiffness times squared branch along the axes, summed over contacts, N m.
  virtual Vec3 stiffen(const Scene& scene, Contacts& contacts) = 0;
  virtual StoredEnergies stored(const Scene& scene, Contacts& contacts) = 0;
  /// Returns the largest stiffnesses of a grain of a material below `materials` and an equal one of any material at the
  /// given radius and overlap, m: they bound the step before contacts form (step_bound.h).
  virtual PairStiffness stiffness(double radius, double overlap, std::int32_t materials, int dimension) const = 0;
};

/// The sweep for the law and materials of a model, eight contacts at a time where the processor has AVX-512, else four:
/// the bits are the same.
std::unique_ptr<ContactSweep> make_contact_sweep(const Model& model);
std::unique_ptr<ContactSweep> make_contact_sweep_of_four(const Model& model);
std::unique_ptr<ContactSweep> make_contact_sweep_of_eight(const Model& model);

}  // namespace soilweave::dem
