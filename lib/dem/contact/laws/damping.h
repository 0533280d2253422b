// Viscous damping of the normal force.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "dem/contact/kinematics.h"

namespace soilweave::dem {

/// Returns the restitution (0 < e <= 1) of a spring with a dashpot of damping ratio `beta`.
/// `attraction`: whether the contact force may pull until the overlap is gone.
/// Source for linear springs: Schwager & Poeschel 2007. A Hertz spring with a dashpot ~ overlap^(1/4) has the same
/// restitution, since overlap^(5/4) obeys the linear equation (Antypov & Elliott 2011). Thornton, Cummins & Cleary 2013
/// fit a polynomial to the inverse function.
inline double restitution(double beta, bool attraction) {
  if (attraction) return beta < 1 ? std::exp(-std::numbers::pi * beta / std::sqrt((1 - beta) * (1 + beta))) : 0.0;
  const double w2 = (1 - beta) * (1 + beta);
  if (std::abs(w2) < 1e-12) return std::exp(-2.0);
  return w2 > 0 ? std::exp(-2 * beta * std::acos(beta) / std::sqrt(w2))
                : std::exp(-2 * beta * std::acosh(beta) / std::sqrt(-w2));
}

/// Returns the damping ratio for a restitution.
/// With attraction it is -ln e / sqrt(pi^2 + ln^2 e) (Tsuji et al. 1992).
inline double damping_ratio(double e, bool attraction) {
  if (e >= 1) return 0;
  const double log_e = std::log(e);
  if (attraction) return -log_e / std::hypot(std::numbers::pi, log_e);
  // Restitution falls with beta; for large beta it is (2 beta)^-2.
  double low = 0, high = 1 / e;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (restitution(middle, false) > e ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Dashpot of a pair of materials.
struct Damping {
  /// Damping ratio beta, 1.
  double ratio = 0;
  /// Whether the dashpot may pull while the bodies part.
  bool attraction = false;

  /// Mixes two restitutions: the smaller counts, and an unset one is 1.
  static Damping mix(std::optional<double> e1, std::optional<double> e2, bool attraction) {
    return {damping_ratio(std::min(e1.value_or(1.0), e2.value_or(1.0)), attraction), attraction};
  }

  /// Returns the elastic force plus 2 critical_fraction sqrt(m* stiffness) approach_speed, N.
  /// Without attraction the sum is cut at zero.
  template <class T, class Space>
  T force(const T& elastic, double critical_fraction, const T& stiffness, const Kinematics<T, Space>& k) const {
    if (ratio == 0) return elastic;
    const T sum = elastic + 2.0 * critical_fraction * square_root(k.m_star() * stiffness) * k.approach_speed;
    return attraction ? sum : maximum(sum, broadcast<T>(0));
  }
  /// Returns the energy that the dashpot takes over dt, J.
  template <class T, class Space>
  T work(const T& force, const T& elastic, const Kinematics<T, Space>& k, const T& dt) const {
    return ratio == 0 ? broadcast<T>(0) : T((force - elastic) * k.approach_speed * dt);
  }
};

}  // namespace soilweave::dem
