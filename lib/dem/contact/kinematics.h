// Motion of one contact over one step, the input of every contact law.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/state/space.h"

namespace soilweave::dem {

/// Vectors point from body 1 to body 2. T is double or lanes, one contact each.
/// Increments are of body 2 relative to body 1, over the step to the present positions.
template <class T, class Space = Spatial>
struct Kinematics {
  /// Unit vector from body 1 to body 2.
  Vector<T, Space> normal;
  /// Overlap, m; positive in contact.
  T overlap;
  /// Rate of the overlap, m/s.
  T approach_speed;
  /// Shear displacement increment, m.
  Along<T, Space> slip;
  /// Increment of the relative rotation normal to `normal`, rad.
  Turn<T, Space> roll;
  /// Increment of the relative rotation about `normal`, rad; absent in the plane.
  T twist;
  /// Radii, m; r2 = r1 against a plane.
  T r1, r2;
  /// Reduced radius r1 r2/(r1 + r2), m; r1 against a plane.
  T R_star;
  /// Inverse sum of the radii, 1/(r1 + r2), 1/m.
  T per_reach;
  /// Masses, kg; a plane's is infinite.
  T m1, m2;

  /// Returns the reduced mass, kg.
  T m_star() const { return m1 / (1.0 + m1 / m2); }
};

}  // namespace soilweave::dem
