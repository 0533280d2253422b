// Work on contacts in a step, and their dissipation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/laws/contact.h"
#include "dem/contact/pair_geometry.h"
#include "dem/sweep/row_sums.h"

namespace soilweave::dem {

/// Work and dissipation of one contact in a step.
template <class T>
struct Work {
  /// Work on the springs times -2, and energies lost, J.
  T on_springs, frictional, rolling_plastic, viscous;
};

/// Returns the work and dissipation of a step; the work by the trapezoidal rule.
template <class T, class Space>
Work<T> work_of(const PairGeometry<T, Space>& g, const ContactHistory<T, Space>& before,
                const ContactHistory<T, Space>& after, bool moments, const ContactEnergies<T>& b) {
  T twice = product(Along<T, Space>(before.shear + after.shear), g.surface_slip);
  if (moments) {
    twice += product(Turn<T, Space>(before.rolling + after.rolling), g.kinematics.roll);
    if constexpr (Space::twists) twice = fused(T(before.twisting + after.twisting), g.kinematics.twist, twice);
  }
  return {twice, b.frictional, b.rolling_plastic, b.viscous};
}

/// Adds the work of every contact to a row.
template <class T>
void add_to(Lane4& row, const Work<T>& w) {
  add_to(row, w.on_springs, w.frictional, w.rolling_plastic, w.viscous);
}

}  // namespace soilweave::dem
