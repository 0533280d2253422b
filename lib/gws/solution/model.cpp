// The wrapped soil at one moment.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/model.h"

#include <cmath>

namespace soilweave::gws {
namespace {

constexpr double greatest_pressure = 1e9;  // Pa

/// Solves eta = A - kappa / (D + G eta) on the branch that tends to A - kappa / D as G vanishes. NaN if there is no
/// solution.
double stress_ratio(double A, double D, double G, double kappa) {
  const double b = D - A * G, c = kappa - A * D;
  const double discriminant = b * b - 4 * G * c;
  if (!(discriminant >= 0) || !(D > 0)) return std::nan("");
  return -2 * c / (b + std::sqrt(discriminant));
}

}  // namespace

std::string_view reason(End end) {
  switch (end) {
    case End::none:
      return "goes on";
    case End::surcharge:
      return "the surcharge asked for is reached";
    case End::strength:
      return "the hoop strain reaches the stated fraction of the geotextile's strength";
    case End::failure_strain:
      return "the hoop strain reaches the geotextile's failure strain";
    case End::stress_ratio:
      return "q/p leaves the range from 0 to 3, where the vertical stress is the greatest and the lateral one positive";
    case End::no_stress_ratio:
      return "no q/p is on the near-failure-state line with the elastic deviatoric strain";
    case End::flow:
      return "the dilatancy leaves the range where plastic strain shortens and spreads the bag";
    case End::unstable:
      return "the deviatoric strain grows without bound at this stress";
    case End::stiffness:
      return "the plastic axial strain would decrease under load";
    case End::collapse:
      return "the axial strain reaches 100 %";
    case End::pressure:
      return "the mean stress reaches 1 GPa, far beyond any test of soil";
    case End::softening:
      return "the surcharge has a peak";
    case End::resolution:
      return "the path has a kink that no increment resolves";
  }
  return "";
}

double failure_obliquity(const Soil& soil, double p) { return soil.M * std::pow(p / soil.p_c, -soil.n); }

double elastic_volumetric(const Soil& soil, double p) {
  return soil.C_t * (std::pow(p / soil.p_a, soil.m) - std::pow(soil.p_0 / soil.p_a, soil.m));
}

double elastic_shear_factor(const Soil& soil) {
  return 2 * (1 + soil.poisson_ratio) / (9 * (1 - 2 * soil.poisson_ratio));
}

double dilatancy(const Soil& soil, double failure, double obliquity) {
  return soil.p_1 * (failure - obliquity) - soil.p_2 - (failure - soil.M);
}

double plastic_ratio(double X) { return (2 * X - 3) / (2 * X + 6); }

std::array<double, 2> generalized_stress(const Soil& soil, double K_psi) {
  // [2 + K_psi K' - 2 nu (1 + K_psi + K')] / [K_psi (K' + 2)] with K' = (3 + 2s)/(3 - s), so that K' + 2 = 9/(3 - s).
  const double nu = soil.poisson_ratio;
  const double constant = 2 - 2 * nu * (1 + K_psi), ratio = K_psi - 2 * nu;
  return {(constant + ratio) / (3 * K_psi), (2 * ratio - constant) / (9 * K_psi)};
}

SoilState soil_state(const Soil& soil, double E, double p, const Plastic& plastic) {
  SoilState at;
  at.p = p;
  const auto ended = [&at](End why) {
    at.end = why;
    return at;
  };
  if (!(p < greatest_pressure)) return ended(End::pressure);
  const double power = soil.C_t * std::pow(p / soil.p_a, soil.m);
  const double elastic = power - soil.C_t * std::pow(soil.p_0 / soil.p_a, soil.m);
  const double elastic_rate = soil.m * power;  // d eps_v^e / d ln p
  const double factor = elastic_shear_factor(soil);
  const double failure = failure_obliquity(soil, p);
  const double plastic_deviatoric = 2.0 / 3.0 * (plastic[0] - plastic[1]);

  const double eta = stress_ratio(failure + soil.xi, plastic_deviatoric + soil.lambda, factor * elastic, soil.kappa);
  if (!std::isfinite(eta)) return ended(End::no_stress_ratio);
  if (!(eta > 0 && eta < 3)) return ended(End::stress_ratio);
  const double elastic_deviatoric = factor * eta * elastic;
  at.failure_obliquity = failure;
  at.obliquity = eta;
  at.strain_axial = elastic / 3 + elastic_deviatoric + plastic[0];
  at.strain_radial = elastic / 3 - elastic_deviatoric / 2 + plastic[1];
  at.strain_volumetric = at.strain_axial + 2 * at.strain_radial;
  at.strain_deviatoric = elastic_deviatoric + plastic_deviatoric;
  if (!(at.strain_axial < 100)) return ended(End::collapse);

  at.dilatancy = dilatancy(soil, failure, eta);
  if (!(at.dilatancy > -3 && at.dilatancy < 1.5)) return ended(End::flow);
  const double K_psi = at.plastic_ratio = plastic_ratio(at.dilatancy);
  const auto [c_0, c_1] = generalized_stress(soil, K_psi);

  // Derivatives by ln p: eta' = -n M_f + h eps_d', eps_d' = factor (eta' eps_v^e + eta eps_v^e') + 2/3 (1 - K_psi)
  // eps_a^p', eps_a^p' = (100 p / E)(c_0 + c_1 s), s = eta + eta'.
  const double h = soil.kappa / ((at.strain_deviatoric + soil.lambda) * (at.strain_deviatoric + soil.lambda));
  const double scale = 100 * p / E, shear = 2.0 / 3.0 * (1 - K_psi) * scale;
  const double resistance = 1 - h * (factor * elastic + shear * c_1);
  if (!(resistance > 0)) return ended(End::unstable);
  const double slope = (-soil.n * failure + h * (factor * eta * elastic_rate + shear * (c_0 + c_1 * eta))) / resistance;
  at.path_slope = eta + slope;
  at.plastic_rate = scale * (c_0 + c_1 * at.path_slope);
  if (!(at.plastic_rate >= 0)) return ended(End::stiffness);
  at.axial_rate = elastic_rate / 3 + factor * (slope * elastic + eta * elastic_rate) + at.plastic_rate;
  return at;
}

double hoop_share(const Bag& bag, const SoilState& state) {
  const double slenderness = bag.height / bag.width;
  return slenderness / (1 + slenderness) * (1 - state.strain_axial / 100) / (1 - state.strain_radial / 100);
}

double surcharge(const Bag& bag, const SoilState& state, double outer_lateral) {
  return state.axial_stress() - 2 * (state.lateral_stress() - outer_lateral) * hoop_share(bag, state);
}

double hoop_tension(const Bag& bag, const SoilState& state, double outer_lateral) {
  return (state.lateral_stress() - outer_lateral) * bag.width * bag.height * (1 - state.strain_axial / 100) *
         (1 - state.strain_radial / 100) / (2 * (bag.width + bag.height));
}

}  // namespace soilweave::gws
