// Single lanes of vectors of registers, which only tests look at.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simd/v3.h"

namespace soilweave {

/// Return one lane; replace one lane.
inline V3<double> lane(const V3<Lane4>& v, int i) { return {v.x[i], v.y[i], v.z[i]}; }
inline void set_lane(V3<Lane4>& v, int i, const V3<double>& value) {
  v.x[i] = value.x;
  v.y[i] = value.y;
  v.z[i] = value.z;
}

}  // namespace soilweave
