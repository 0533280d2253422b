// The wrapped soil at one moment, and its balance with geotextile and surcharge (thesis section 5.3).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "gws/solution/soil.h"

namespace soilweave::gws {

/// Plastic axial and radial strain, percent: the only history of the model.
using Plastic = std::array<double, 2>;

/// Why a response ends, always for one reason.
enum class End {
  none,
  /// The requested surcharge is reached.
  surcharge,
  /// The hoop strain is at the stated fraction of the strength.
  strength,
  /// The failure strain comes first.
  failure_strain,
  /// q/p leaves the range where the vertical stress is greatest.
  stress_ratio,
  /// No q/p satisfies Eq. 5.4 with the elastic strain of Eq. 5.7.
  no_stress_ratio,
  /// The dilatancy leaves the range where the bag shortens and spreads.
  flow,
  /// Strain grows without bound at this stress.
  unstable,
  /// Plastic axial strain would decrease under load.
  stiffness,
  /// The height of the bag is zero.
  collapse,
  /// The mean stress is far beyond any test of soil.
  pressure,
  /// The surcharge peaks.
  softening,
  /// The path has a kink that no step resolves.
  resolution,
};
/// Returns the reason as a sentence without full stop.
std::string_view reason(End end);

/// State of the soil at mean stress p. Strains are total, in percent.
struct SoilState {
  /// Reason why the state does not exist; none: it exists. Numbers after the cause mean nothing.
  End end = End::none;
  /// Mean stress, Pa.
  double p = 0;
  /// q/p at failure, M_f; present q/p, eta.
  double failure_obliquity = 0, obliquity = 0;
  double strain_axial = 0, strain_radial = 0, strain_volumetric = 0, strain_deviatoric = 0;
  /// Dilatancy X = d eps_v^p / d eps_d^p, contraction positive.
  double dilatancy = 0;
  /// Ratio K_psi = d eps_r^p / d eps_a^p.
  double plastic_ratio = 0;
  /// Slope s = dq/dp along the path.
  double path_slope = 0;
  /// Rate d eps_a^p / d ln p, percent.
  double plastic_rate = 0;
  /// Rate d eps_a / d ln p, percent, elastic and plastic.
  double axial_rate = 0;

  /// Return sigma_a and sigma_r, Pa, from p and q/p.
  double axial_stress() const { return p * (3 + 2 * obliquity) / 3; }
  double lateral_stress() const { return p * (3 - obliquity) / 3; }
  /// Returns K', Eq. 5.10.
  double stress_increment_ratio() const { return (3 + 2 * path_slope) / (3 - path_slope); }
};

/// Returns q/p at failure, Eq. 5.5.
double failure_obliquity(const Soil& soil, double p);
/// Returns the elastic volumetric strain, percent, Eq. 5.6.
double elastic_volumetric(const Soil& soil, double p);
/// Returns eps_d^e / (eta eps_v^e), Eq. 5.7.
double elastic_shear_factor(const Soil& soil);
/// Returns X from the distance to failure, Eq. 5.12.
double dilatancy(const Soil& soil, double failure, double obliquity);
/// Returns K_psi from X by the last form of Eq. 5.11; the middle form differs.
double plastic_ratio(double dilatancy);
/// Returns the coefficients of 1 and of s in dp*/dp, Eq. 5.14.
std::array<double, 2> generalized_stress(const Soil& soil, double plastic_ratio);

/// Returns the state at p, Pa, with the plastic strain so far. E: Young's modulus, Pa. Eq. 5.7 makes a quadratic
/// equation of q/p and the deviatoric strain. The plastic rate and the path's slope depend on each other linearly. Both
/// are solved in closed form, the limit of the thesis's ever smaller increments.
SoilState soil_state(const Soil& soil, double E, double p, const Plastic& plastic);

/// A bag.
struct Bag {
  /// Width B and height H, m.
  double width = 0.4, height = 0.08;
};

/// Returns half the share of (sigma_r - sigma_rs) that the hoops take off the surcharge: (H/B)(1 - eps_a) / ((1 +
/// H/B)(1 - eps_r)).
double hoop_share(const Bag& bag, const SoilState& state);
/// Returns the surcharge sigma_as, Pa, under the lateral stress sigma_rs outside, Eq. 5.3.
double surcharge(const Bag& bag, const SoilState& state, double outer_lateral);
/// Returns the hoop tension t_h, N/m, Eq. 5.2: J times Eq. 5.16 with the length B that the print lacks.
double hoop_tension(const Bag& bag, const SoilState& state, double outer_lateral);

}  // namespace soilweave::gws
