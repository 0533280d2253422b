// The motion of one contact over one step: geometry only, no forces. What every contact law is given.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/space.h"

namespace soilweave::dem {

/// Body 1 to body 2; all increments are of body 2 relative to body 1 over the step that led to the present positions.
/// T is double or a vector of doubles (one contact a lane).
template <class T, class Space = Spatial>
struct Kinematics {
  Vector<T, Space> normal;  // unit, from body 1 to body 2
  T overlap;                // m, > 0 in contact
  T approach_speed;         // m/s, rate of the overlap
  Along<T, Space> slip;     // m, shear displacement increment
  Turn<T, Space> roll;      // rad, increment of the relative rotation, normal to `normal`
  T twist;                  // rad, increment of the relative rotation about `normal`; not in the plane
  T r1, r2;                 // m; against a plane r2 = r1
  T R_star;                 // m, r1 r2/(r1 + r2); against a plane r1
  T per_reach;              // 1/m, of r1 + r2
  T m1, m2;                 // kg; a plane's is infinite

  T m_star() const { return m1 / (1.0 + m1 / m2); }  // kg, reduced mass
};

}  // namespace soilweave::dem
