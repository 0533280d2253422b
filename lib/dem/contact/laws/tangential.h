// Shear with Coulomb's limit, rolling and twisting, which all laws share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "dem/contact/laws/contact.h"
#include "dem/contact/laws/resistance.h"

namespace soilweave::dem {

/// Tangential parameters of a pair of materials.
struct Tangential {
  /// Tangent of the friction angle.
  double mu;
  /// Resistance to rolling and to twisting.
  PairResistance rolling, twisting;

  /// Returns whether contacts can have moments.
  bool uses_moments() const { return rolling.stiffness > 0 || twisting.stiffness > 0; }

  /// Removes the shear force, and the moments whose stiffness scales with ks.
  template <class T, class Space>
  void let_go(ContactHistory<T, Space>& history) const {
    history.shear = Along<T, Space>{};
    if (rolling.scale == Resistance::Scale::contact) history.rolling = Turn<T, Space>{};
    if (twisting.scale == Resistance::Scale::contact) history.twisting = T{};
  }
};

/// Returns the smaller friction angle, rad. If one material alone has `friction_decides`, its angle counts instead.
template <class Material>
double mix_friction(const Material& a, const Material& b) {
  if (a.friction_decides != b.friction_decides) return a.friction_decides ? a.friction_angle : b.friction_angle;
  return std::min(a.friction_angle, b.friction_angle);
}

/// Mixes the tangential parts of two materials.
template <class Material>
Tangential mix_tangential(const Material& a, const Material& b) {
  return {std::tan(mix_friction(a, b)), mix(a.rolling, b.rolling), mix(a.twisting, b.twisting)};
}

/// Completes a response with known normal force and shear stiffness.
/// Fs <- Fs - ks slip, |Fs| <= mu Fn (LAWS.md §2, §3). Updates `history`, and `energies` of the three springs.
template <class T, class Space>
void tangential_step(const Tangential& c, const Kinematics<T, Space>& k, ContactHistory<T, Space>& history,
                     Response<T>& r, ContactEnergies<T>& energies) {
  const T pressing = maximum(r.normal_force, broadcast<T>(0));
  r.pressing = pressing;
  r.rolling_stiffness = resistance_stiffness(c.rolling, k, r.shear_stiffness);
  r.twisting_stiffness = resistance_stiffness(c.twisting, k, r.shear_stiffness);
  const auto shear = limited_spring_step<T, Along<T, Space>>(history.shear, r.shear_stiffness, k.slip, c.mu * pressing);
  const auto roll =
      resistance_step<T, Turn<T, Space>>(c.rolling, k, history.rolling, r.rolling_stiffness, k.roll, pressing);
  SpringStep<T, T> twist{};
  if constexpr (Space::twists)
    twist = resistance_step<T, T>(c.twisting, k, history.twisting, r.twisting_stiffness, k.twist, pressing);
  history = {shear.force, roll.force, twist.force};
  r.sliding = shear.limited;
  energies.elastic_shear = shear.stored, energies.elastic_rolling = roll.stored,
  energies.elastic_twisting = twist.stored;
  energies.frictional = shear.dissipated;
  energies.rolling_plastic = roll.dissipated + twist.dissipated;
}

}  // namespace soilweave::dem
