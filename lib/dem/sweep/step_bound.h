// Bound on the time step from contacts that do not exist yet.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/state/bodies.h"
#include "dem/sweep/contact_sweep.h"

namespace soilweave::dem {

/// Least values over all bodies. Each may belong to a different body.
struct Smallest {
  /// Radius, m; mass, kg; moment of inertia without nodes, kg m2.
  double radius, mass, inertia;
  explicit Smallest(const Bodies& bodies)
      : radius(bodies.smallest_radius()), mass(bodies.smallest_mass()), inertia(bodies.smallest_inertia()) {}
};

/// Relative overlap of the contact that bounds the step while no stiffer one exists.
inline constexpr double reference_overlap = 1e-4;

/// Time steps, s, that stay stable when contacts form; infinite without stiffness.
struct StepBound {
  /// Translation: sqrt(2 m/(4 k_n)) at the reference overlap.
  /// The four allows for several contacts at once, and for growing stiffness.
  double translation;
  /// Rolling and twisting: sqrt(2 I/k_r), for equal grains that rotate against each other.
  double rotation;
  /// Share of these bounds, and of those of present contacts, that dashpots leave: sqrt(1 + xi^2) - xi, 1 without any.
  /// Source: Belytschko et al. 2014, chapter 6, for damping forces that lag by half a step. xi = sqrt(2) beta where
  /// each axis has two contacts of damping ratio beta, one on either side of a grain.
  double dashpots;
};

/// Returns the bound from the smallest values and the stiffest contact of any materials.
StepBound bound_to_come(const ContactSweep& sweep, const Bodies& bodies, const Smallest& smallest);

}  // namespace soilweave::dem
