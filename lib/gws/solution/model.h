// The wrapped soil at one moment (thesis section 5.3): stress ratio, dilatancy, elastic and plastic strain, and the
// balance of forces between soil, geotextile and surcharge. Pure functions; nothing here integrates.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "gws/solution/soil.h"

namespace soilweave::gws {

/// Plastic axial and radial strain, percent. They are the only history of the model.
using Plastic = std::array<double, 2>;

/// Why a response ends. Every response ends with exactly one of these.
enum class End {
  none,
  surcharge,        // reached the surcharge asked for
  strength,         // hoop strain at the stated fraction of the geotextile's strength
  failure_strain,   // failure strain of the geotextile, if it comes first
  stress_ratio,     // q/p leaves the range where the vertical stress is the greatest
  no_stress_ratio,  // no q/p satisfies Eq. 5.4 with the elastic deviatoric strain of Eq. 5.7
  flow,             // the dilatancy leaves the range where the bag shortens and spreads
  unstable,         // strain grows without bound at this stress
  stiffness,        // plastic axial strain would decrease under load
  collapse,         // height of the bag is zero
  pressure,         // mean stress far beyond any test of soil
  softening,        // peak of the surcharge
  resolution,       // kink of the path that no step resolves
};
/// Returns the reason as one sentence without a full stop.
std::string_view reason(End end);

/// State of the soil at mean stress p. Strains are total (elastic plus plastic), in percent.
struct SoilState {
  End end = End::none;  // if not none, the state does not exist, and numbers after the cause mean nothing
  double p = 0;         // Pa
  double failure_obliquity = 0, obliquity = 0;  // M_f, eta = q/p
  double strain_axial = 0, strain_radial = 0, strain_volumetric = 0, strain_deviatoric = 0;
  double dilatancy = 0;      // X = d eps_v^p / d eps_d^p, contraction positive
  double plastic_ratio = 0;  // K_psi = d eps_r^p / d eps_a^p
  double path_slope = 0;     // s = dq/dp along the path
  double plastic_rate = 0;   // d eps_a^p / d ln p, percent
  double axial_rate = 0;     // d eps_a / d ln p, percent: elastic and plastic

  /// Return sigma_a and sigma_r, Pa, from p and q/p.
  double axial_stress() const { return p * (3 + 2 * obliquity) / 3; }
  double lateral_stress() const { return p * (3 - obliquity) / 3; }
  double stress_increment_ratio() const { return (3 + 2 * path_slope) / (3 - path_slope); }  // K', Eq. 5.10
};

/// Returns q/p at failure, Eq. 5.5.
double failure_obliquity(const Soil& soil, double p);
/// Returns the elastic volumetric strain, percent, Eq. 5.6.
double elastic_volumetric(const Soil& soil, double p);
/// Returns eps_d^e / (eta eps_v^e), Eq. 5.7.
double elastic_shear_factor(const Soil& soil);
/// Returns X from the distance to failure, Eq. 5.12, contraction positive.
double dilatancy(const Soil& soil, double failure, double obliquity);
/// Returns K_psi from X by the last form of Eq. 5.11. The middle form of that equation gives another number.
double plastic_ratio(double dilatancy);
/// Returns the coefficients of 1 and of s in dp*/dp (Eq. 5.14), which is linear in s = dq/dp.
std::array<double, 2> generalized_stress(const Soil& soil, double plastic_ratio);

/// Returns the state at p with the plastic strain accumulated so far. E: Young's modulus, Pa. q/p and the deviatoric
/// strain depend on each other through Eq. 5.7, a quadratic equation. The plastic rate and the slope of the stress path
/// depend on each other linearly. Both are solved in closed form, which is the limit of the thesis's ever smaller
/// increments.
SoilState soil_state(const Soil& soil, double E, double p, const Plastic& plastic);

/// Width B and height H of a bag, m.
struct Bag {
  double width = 0.4, height = 0.08;
};

/// Returns half the share of (sigma_r - sigma_rs) by which the hoops reduce the surcharge: (H/B)(1 - eps_a) / ((1 +
/// H/B)(1 - eps_r)).
double hoop_share(const Bag& bag, const SoilState& state);
/// Returns the surcharge sigma_as, Pa, for the lateral stress sigma_rs outside the bag, Eq. 5.3.
double surcharge(const Bag& bag, const SoilState& state, double outer_lateral);
/// Returns the hoop tension t_h, N/m, from the lateral balance Eq. 5.2. It is J times Eq. 5.16 with the length B that
/// the print lacks.
double hoop_tension(const Bag& bag, const SoilState& state, double outer_lateral);

}  // namespace soilweave::gws
