// Resistance to rolling and to twisting: an elastic spring with an optional plastic limit, held by any law.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "dem/kinematics.h"

namespace soilweave::dem {

struct Resistance {
  enum class Scale { absolute, contact };  // stiffness in N m/rad, or a factor on ks r1 r2
  enum class Arm { mean_radius, smaller_radius };
  double stiffness = 0;
  Scale scale = Scale::absolute;
  std::optional<double> limit;  // moment at most limit * arm * normal force; none: elastic; 0: no moment at all
  Arm arm = Arm::mean_radius;
};

/// Two materials in contact: stiffnesses in series where the scale is the contact's (harmonic mean, dem-laws §3), the
/// smaller one where it is absolute; the tighter of the two limits.
inline Resistance mix(const Resistance& a, const Resistance& b) {
  Resistance m = a;
  const double sum = a.stiffness + b.stiffness;
  if (a.scale == Resistance::Scale::absolute)
    m.stiffness = std::min(a.stiffness, b.stiffness);
  else
    m.stiffness = sum > 0 ? 2 * a.stiffness * b.stiffness / sum : 0;
  if (b.limit) m.limit = a.limit ? std::min(*a.limit, *b.limit) : *b.limit;
  return m;
}

/// N m/rad. shear_stiffness: the law's tangent ks, N/m.
template <class T>
T resistance_stiffness(const Resistance& r, const Kinematics<T>& k, const T& shear_stiffness) {
  if (r.scale == Resistance::Scale::absolute) return all<T>(r.stiffness);
  return r.stiffness * shear_stiffness * k.r1 * k.r2;
}

/// Largest moment, N m; negative: none.
template <class T>
T resistance_limit(const Resistance& r, const Kinematics<T>& k, const T& normal_force) {
  if (!r.limit) return all<T>(-1);
  const T arm = r.arm == Resistance::Arm::mean_radius ? 0.5 * (k.r1 + k.r2) : minimum(k.r1, k.r2);
  return *r.limit * arm * normal_force;
}

}  // namespace soilweave::dem
