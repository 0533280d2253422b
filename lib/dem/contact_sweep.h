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

/// Sums over the contacts that a step needs. Energies J; the work terms are of the step that led to the present
/// positions.
struct SweepSums {
  Mat3 force_branch = Mat3::Zero();  // sum of f (x) l, N m; over the volume: the stress, compression positive
  double elastic_normal = 0;
  double elastic_tangential = 0;  // shear, rolling and twisting
  double tangential_before = 0;   // of the old memory at the present stiffness
  double frictional = 0, rolling_plastic = 0, viscous = 0;
  double kinematic = 0;                 // shear work on the grains' true slip minus that on the law's slip
  double plane_work = 0;                // done on the grains by moving planes
  double largest_relative_overlap = 0;  // overlap over the smaller radius
  std::int64_t contacts = 0;
};

/// What is stored in the contacts, J, looked at now and then.
struct StoredEnergies {
  double shear = 0, rolling = 0, twisting = 0;
};

/// What is read of a simulation in a sweep.
struct Scene {
  const Bodies& bodies;
  const Cell& cell;
  const Planes& planes;
  int threads;
};

class ContactSweep {
 public:
  virtual ~ContactSweep() = default;
  /// Updates every pair's contact over a step dt that led to the present positions and adds what it does to its grains
  /// to the loads; dt = 0: positions unmoved, memory as it is (the first sweep of a simulation). What force_branch
  /// lacks is the sum of F (x) x over the grains: Motion::gather has it.
  virtual SweepSums run(const Scene& scene, double dt, Contacts& contacts) = 0;
  /// Adds the stiffness that each contact gives its grains to the loads instead: about the axes x, y, z against
  /// translation in `force`, N/m, and against rotation in `torque`, N m/rad. Changes nothing else. Returns the affine
  /// stiffness times squared branch along the axes, summed over contacts, N m.
  virtual Vec3 stiffen(const Scene& scene, Contacts& contacts) = 0;
  virtual StoredEnergies stored(const Scene& scene, Contacts& contacts) = 0;
  /// Largest normal stiffness of a grain of a material below `materials` and an equal one of any material at the given
  /// overlap, N/m: bounds the step before contacts form.
  virtual double stiffness(double radius, double overlap, std::int32_t materials) const = 0;
};

/// The sweep for the law and materials of a model, eight contacts at a time where the processor has AVX-512, else four:
/// the bits are the same.
std::unique_ptr<ContactSweep> make_contact_sweep(const Model& model);
std::unique_ptr<ContactSweep> make_contact_sweep_of_four(const Model& model);
std::unique_ptr<ContactSweep> make_contact_sweep_of_eight(const Model& model);

}  // namespace soilweave::dem
