// The wrapped soil at one moment: closed forms, identities of the thesis's equations, the balance of forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "gws/solution/model.h"
#include "gws/solution/path.h"
#include "gws/solution/respond.h"
#include "support/gws_reference.h"

namespace soilweave::gws {
namespace {

TEST(GwsModel, BeginsWhereTheTableOfConstantsSays) {
  const Soil soil;
  const SoilState start = soil_state(soil, soil.young_modulus(232e3), soil.p_0, {});
  EXPECT_EQ(start.end, End::none);
  // M_f = 1.35 (2.6/3255)^-0.0723, eta = M_f - 1.386/1.27 + 0.035: 2.26094 - 1.09134 + 0.035.
  EXPECT_NEAR(start.failure_obliquity, 2.2609, 5e-5);
  EXPECT_NEAR(start.obliquity, 1.2046, 5e-5);
  EXPECT_NEAR(start.axial_stress() / start.lateral_stress(), 3.01, 5e-3);
  EXPECT_NEAR(start.dilatancy, 0.52, 5e-4);
  EXPECT_NEAR(start.plastic_ratio, -0.2785, 1e-4);
  EXPECT_EQ(start.strain_axial, 0);
  EXPECT_NEAR(surcharge({}, start, 0), 4169, 0.5);
}

TEST(GwsModel, YoungsModulusIsThePowerOfTheStiffness) {
  const Soil soil;
  EXPECT_NEAR(soil.young_modulus(53e3) / 1e6, 2.97, 5e-3);
  EXPECT_NEAR(soil.young_modulus(232e3) / 1e6, 8.85, 5e-3);
}

TEST(GwsModel, StressRatioSolvesItsImplicitEquation) {
  // eta and eps_d depend on each other (Eqs. 5.4, 5.7): the closed form must satisfy both.
  const Soil soil;
  for (const double p : {5e3, 50e3, 500e3, 3e6}) {
    const SoilState s = soil_state(soil, 9e6, p, {3.0, -1.5});
    ASSERT_EQ(s.end, End::none);
    EXPECT_NEAR(s.obliquity, s.failure_obliquity - soil.kappa / (s.strain_deviatoric + soil.lambda) + soil.xi, 1e-13);
    const double elastic = elastic_volumetric(soil, p);
    EXPECT_NEAR(s.strain_deviatoric, 2.0 / 3.0 * 4.5 + elastic_shear_factor(soil) * s.obliquity * elastic, 1e-12);
    EXPECT_NEAR(s.strain_volumetric, elastic + 3.0 - 3.0, 1e-12);
    EXPECT_NEAR(s.strain_deviatoric, s.strain_axial - s.strain_volumetric / 3, 1e-12);
  }
}

TEST(GwsModel, SlopeOfThePathIsItsOwnDerivative) {
  // s = dq/dp and d eps_a^p/dp are solved together; along the path they must equal difference quotients.
  const Soil soil;
  Path path(soil, soil.young_modulus(232e3), 1e-9);
  while (path.last() < std::log(1e6)) ASSERT_TRUE(path.advance());
  for (const double p : {10e3, 100e3, 800e3}) {
    const double x = std::log(p), d = 1e-4;
    const SoilState below = path.at(x - d), at = path.at(x), above = path.at(x + d);
    const double dq = above.p * above.obliquity - below.p * below.obliquity;
    EXPECT_NEAR(dq / (above.p - below.p), at.path_slope, 1e-6 * at.path_slope) << p;  // second order in d
    const auto plastic = [&](const SoilState& s) {
      return s.strain_axial - elastic_volumetric(soil, s.p) / 3 -
             elastic_shear_factor(soil) * s.obliquity * elastic_volumetric(soil, s.p);
    };
    EXPECT_NEAR((plastic(above) - plastic(below)) / (2 * d), at.plastic_rate, 1e-6 * at.plastic_rate) << p;
  }
}

TEST(GwsModel, GeneralizedStressIsEquation514) {
  Soil soil;
  for (const double K_psi : {-0.28, -0.6})
    for (const double s : {1.2, 1.5}) {
      const double K = (3 + 2 * s) / (3 - s), nu = soil.poisson_ratio;
      const auto [c_0, c_1] = generalized_stress(soil, K_psi);
      EXPECT_NEAR(c_0 + c_1 * s, (2 + K_psi * K - 2 * nu * (1 + K_psi + K)) / (K_psi * (K + 2)), 1e-13);
    }
}

TEST(GwsModel, ForcesBalanceOnEveryFace) {
  // Eqs. 5.1 and 5.2 with one tension: both balances of the cuboid, whose common factor (1 - eps_h) cancels.
  const Bag bag{0.5, 0.1};
  SoilState s;
  s.p = 100e3;
  s.obliquity = 1.4;
  s.strain_axial = 6;
  s.strain_radial = -2;
  const double outer = 20e3, t = hoop_tension(bag, s, outer), as = surcharge(bag, s, outer);
  const double a = 1 - 0.06, r = 1 + 0.02;
  EXPECT_NEAR(t * 2 * (bag.width + bag.height), (s.lateral_stress() - outer) * bag.width * bag.height * a * r, 1e-9);
  EXPECT_NEAR(as * bag.width * bag.width * r * r + 4 * bag.width * t, s.axial_stress() * bag.width * bag.width * r * r,
              1e-9);
}

TEST(GwsModel, LateralStressAndBagLeaveThePathOfTheSoilAlone) {
  // Only E enters the path: at equal p, strains are the same with any lateral stress and bag.
  Case one = test::bag_of("PP"), other = one;
  other.lateral = LateralStress::constant(50e3);
  other.bag = {0.6, 0.1};
  const Point a = Response(one).at_strain(0.05), b = Response(other).at_strain(0.05);
  EXPECT_NEAR(a.soil.p, b.soil.p, 1e-9 * a.soil.p);
  EXPECT_NEAR(a.soil.strain_radial, b.soil.strain_radial, 1e-9);
  EXPECT_LT(a.surcharge, b.surcharge);
}

TEST(GwsModel, EveryEndHasAReason) {
  for (int end = 0; end <= static_cast<int>(End::resolution); ++end)
    EXPECT_FALSE(reason(static_cast<End>(end)).empty()) << end;
}

}  // namespace
}  // namespace soilweave::gws
