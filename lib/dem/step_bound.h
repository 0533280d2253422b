// The bound that contacts still to come set to the time step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/bodies.h"
#include "dem/contact_sweep.h"

namespace soilweave::dem {

/// The least radius (m), mass (kg) and moment of inertia (kg m2, nodes apart) of any body, each by itself.
struct Smallest {
  double radius, mass, inertia;
  explicit Smallest(const Bodies& bodies)
      : radius(bodies.smallest_radius()), mass(bodies.smallest_mass()), inertia(bodies.smallest_inertia()) {}
};

/// Overlap over radius of the contact that bounds the step while no stiffer one exists.
inline constexpr double reference_overlap = 1e-4;

/// Time steps, s, that contacts still to come leave stable; infinite where a model has no such stiffness.
struct StepBound {
  /// Translation: sqrt(2 m/(4 k_n)) at the reference overlap. The four stands for several contacts at once, and for a
  /// stiffness that grows with the overlap before it is looked at again.
  double translation;
  /// Rolling and twisting: sqrt(2 I/k_r), the limit of two equal grains that turn against each other. A moment's
  /// stiffness may be the same from the first touch on, and large beside that of so small an overlap.
  double rotation;
};

StepBound bound_to_come(const ContactSweep& sweep, const Bodies& bodies, const Smallest& smallest);

}  // namespace soilweave::dem
