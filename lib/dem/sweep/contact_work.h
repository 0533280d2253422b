// Work on contacts in a step, and their dissipation, for the energy balance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/laws/contact.h"
#include "dem/contact/pair_geometry.h"
#include "dem/sweep/row_sums.h"

namespace soilweave::dem {

/// Work and dissipation of one contact in a step.
template <class T>
struct Work {
  T on_springs, frictional, rolling_plastic, viscous;  // J; the first one times -2
};

/// Forces and moments before and after the step count half each (trapezoidal rule).
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

template <class T>
void add_to(Lane4& row, const Work<T>& w) {
  add_to(row, w.on_springs, w.frictional, w.rolling_plastic, w.viscous);
}

}  // namespace soilweave::dem
