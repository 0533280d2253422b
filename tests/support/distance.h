// Distances for searches through all pairs. Vectors would take ten times as long here, since tests are compiled without
// optimisation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tensor.h"

namespace soilweave::support {

/// Returns the squared distance of two points, m2.
inline double squared_distance(const Vec3& a, const Vec3& b) {
  const double *p = a.data(), *q = b.data();
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return x * x + y * y + z * z;
}

}  // namespace soilweave::support
