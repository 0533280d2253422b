// Resistance to rolling and twisting: a spring with an optional plastic limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "core/error.h"
#include "dem/contact/kinematics.h"
#include "dem/contact/laws/contact.h"

namespace soilweave::dem {

/// Resistance of one material to rolling or twisting.
struct Resistance {
  /// Unit of the stiffness: N m/rad, or a factor on ks r1 r2.
  enum class Scale { absolute, contact };
  /// Length over which the plastic limit acts.
  enum class Arm { mean_radius, smaller_radius };
  /// Stiffness in its scale.
  double stiffness = 0;
  /// Scale of the stiffness.
  Scale scale = Scale::absolute;
  /// Greatest moment over (arm * normal force). Unset: the spring is elastic; 0: there is no moment.
  std::optional<double> limit;
  /// Arm of the limit.
  Arm arm = Arm::mean_radius;
};

/// Resistance of two materials in contact. Each side keeps its own limit (LAWS.md §3).
struct PairResistance {
  /// Stiffness in its scale.
  double stiffness = 0;
  /// Scale of the stiffness.
  Resistance::Scale scale = Resistance::Scale::absolute;
  /// Arm of the limits.
  Resistance::Arm arm = Resistance::Arm::mean_radius;
  /// Whether either side has a limit.
  bool limited = false;
  /// Limits of the two sides; infinite on a side without one.
  double limit_1 = 0, limit_2 = 0;
};

/// Mixes two resistances. A limit of 0 removes the stiffness.
/// The pair has the harmonic mean of stiffnesses scaled by the contact (LAWS.md §3), and the smaller absolute one.
/// Throws DataError if scales or arms differ.
inline PairResistance mix(const Resistance& a, const Resistance& b) {
  if (a.stiffness > 0 && b.stiffness > 0 && (a.scale != b.scale || a.arm != b.arm))
    throw DataError("rolling or twisting resistance: two materials in contact must have the same scale and arm");
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  PairResistance m;
  m.scale = a.scale, m.arm = a.arm;
  m.limited = a.limit || b.limit;
  m.limit_1 = a.limit.value_or(unlimited), m.limit_2 = b.limit.value_or(unlimited);
  if (std::min(a.stiffness, b.stiffness) == 0 || std::min(m.limit_1, m.limit_2) == 0) return m;
  m.stiffness = a.scale == Resistance::Scale::absolute ? std::min(a.stiffness, b.stiffness)
                                                       : 2 / (1 / a.stiffness + 1 / b.stiffness);
  return m;
}

/// Returns the stiffness, N m/rad. `shear_stiffness`: tangent ks of the law, N/m.
template <class T, class Space>
T resistance_stiffness(const PairResistance& r, const Kinematics<T, Space>& k, const T& shear_stiffness) {
  if (r.scale == Resistance::Scale::absolute) return broadcast<T>(r.stiffness);
  return r.stiffness * shear_stiffness * k.r1 * k.r2;
}

/// Returns the compliance of resistance_stiffness, rad/(N m); 0 without stiffness.
template <class T>
T resistance_compliance(const PairResistance& r, const T& stiffness) {
  if (r.scale == Resistance::Scale::absolute) return broadcast<T>(r.stiffness > 0 ? 1 / r.stiffness : 0);
  return compliance_of(stiffness);
}

/// Returns the greatest moment of a limited resistance, N m. `normal_force`: N, not negative.
template <class T, class Space>
T resistance_limit(const PairResistance& r, const Kinematics<T, Space>& k, const T& normal_force) {
  const T arm = r.arm == Resistance::Arm::mean_radius ? T(0.5 * std::min(r.limit_1, r.limit_2) * (k.r1 + k.r2))
                                                      : minimum(T(r.limit_1 * k.r1), T(r.limit_2 * k.r2));
  return arm * normal_force;
}

/// Applies rolling (a vector) or twisting (a scalar) resistance over one step.
/// Without stiffness the moment is zero, whatever it was before.
template <class T, class Quantity, class Space>
SpringStep<T, Quantity> resistance_step(const PairResistance& r, const Kinematics<T, Space>& k, const Quantity& old,
                                        const T& stiffness, const Quantity& increment, const T& normal_force) {
  if (!(r.stiffness > 0)) {
    SpringStep<T, Quantity> none{};
    none.limited = broadcast<T>(0) > broadcast<T>(0);
    return none;
  }
  if (!r.limited) return spring_step<T, Quantity>(old, stiffness, resistance_compliance(r, stiffness), increment);
  return limited_spring_step<T, Quantity>(old, stiffness, increment, resistance_limit(r, k, normal_force));
}

}  // namespace soilweave::dem
