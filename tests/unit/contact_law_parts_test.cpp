// Parts that contact laws share: mixing of two materials, dashpots from restitution, lanes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "dem/contact/laws.h"
#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"
#include "support/vector_lanes.h"

namespace soilweave::dem {
namespace {

Kinematics<double> unequal() {
  Kinematics<double> k{};
  k.r1 = 2e-3, k.r2 = 5e-3, k.overlap = 1e-5;
  k.per_reach = 1 / (k.r1 + k.r2), k.R_star = k.r1 * k.r2 * k.per_reach;
  return k;
}

TEST(FrictionOfTwoMaterials, IsTheSmallerUnlessOneDecides) {
  const HertzMindlin::Material sand{4e9, 0.33, 0.5, {}, {}, {}};
  HertzMindlin::Material plate{2e11, 0.33, 1.5, {}, {}, {}};
  EXPECT_DOUBLE_EQ(HertzMindlin::mix(sand, plate).tangential.mu, std::tan(0.5));
  plate.friction_decides = true;
  EXPECT_DOUBLE_EQ(HertzMindlin::mix(sand, plate).tangential.mu, std::tan(1.5));
  EXPECT_DOUBLE_EQ(HertzMindlin::mix(plate, sand).tangential.mu, std::tan(1.5));
  EXPECT_DOUBLE_EQ(HertzMindlin::mix(sand, sand).tangential.mu, std::tan(0.5));
}

TEST(ResistanceOfTwoMaterials, KeepsEachSidesLimitOnItsOwnRadius) {
  const Resistance a{0.5, Resistance::Scale::contact, 0.4, Resistance::Arm::smaller_radius};
  const Resistance b{0.5, Resistance::Scale::contact, 0.1, Resistance::Arm::smaller_radius};
  // min(0.4 x 2 mm, 0.1 x 5 mm), and the other way round min(0.1 x 2 mm, 0.4 x 5 mm).
  EXPECT_DOUBLE_EQ(resistance_limit(mix(a, b), unequal(), 10.0), 5e-3);
  EXPECT_DOUBLE_EQ(resistance_limit(mix(b, a), unequal(), 10.0), 2e-3);
}

TEST(ResistanceOfTwoMaterials, WithTheMeanRadiusTakesTheTighterLimit) {
  const Resistance a{0.5, Resistance::Scale::absolute, 0.4}, b{0.3, Resistance::Scale::absolute, {}};
  EXPECT_DOUBLE_EQ(resistance_limit(mix(a, b), unequal(), 10.0), 0.4 * 3.5e-3 * 10);
  EXPECT_DOUBLE_EQ(resistance_stiffness(mix(a, b), unequal(), 1e6), 0.3);
  EXPECT_FALSE(mix(b, b).limited);
}

TEST(ResistanceOfTwoMaterials, IsInSeriesWhereItScalesWithTheContact) {
  const Resistance a{0.6, Resistance::Scale::contact, {}}, b{0.3, Resistance::Scale::contact, {}};
  EXPECT_DOUBLE_EQ(resistance_stiffness(mix(a, b), unequal(), 1e6), 0.4 * 1e6 * 1e-5);
  EXPECT_DOUBLE_EQ(resistance_stiffness(mix(a, a), unequal(), 1e6), 0.6 * 1e6 * 1e-5);
}

TEST(ResistanceOfTwoMaterials, OfDifferentKindsHasNoMeaning) {
  const Resistance a{0.6, Resistance::Scale::contact, {}}, b{0.3, Resistance::Scale::absolute, {}}, none{};
  EXPECT_THROW(mix(a, b), DataError);
  EXPECT_NO_THROW(mix(a, none));
  EXPECT_EQ(mix(a, none).stiffness, 0);
}

TEST(MaterialsOfACouple, MixAsTheFormulasSay) {
  const HertzMindlin::Material a{4e9, 0.3, 0.5, 0.9, {}, {}}, b{1e9, 0.2, 0.4, {}, {}, {}};
  const auto c = HertzMindlin::mix(a, b);
  EXPECT_DOUBLE_EQ(c.E_star, 1 / (0.91 / 4e9 + 0.96 / 1e9));
  EXPECT_DOUBLE_EQ(c.G_star, 1 / (1.7 * 2.6 / 4e9 + 1.8 * 2.4 / 1e9));
  EXPECT_DOUBLE_EQ(c.tangential.mu, std::tan(0.4));
  EXPECT_NEAR(restitution(c.damping.ratio, c.damping.attraction), 0.9, 1e-14);  // the smaller one of two; unset is 1

  const Linear::Material l{4e8, 0.3, 0.5, {}, {}, {}}, m{1e8, 0.8, 0.4, {}, {}, {}};
  Kinematics<double> k = unequal();
  ContactHistory<double> history{{0, 0, 0}, {0, 0, 0}, 0};
  ContactEnergies<double> energies;
  const auto r = Linear::respond(Linear::mix(l, m), k, 1e-6, history, energies);
  const double n1 = 4e8 * 2e-3, n2 = 1e8 * 5e-3, s1 = 0.3 * n1, s2 = 0.8 * n2;
  EXPECT_DOUBLE_EQ(r.normal_stiffness, 2 * n1 * n2 / (n1 + n2));
  EXPECT_DOUBLE_EQ(r.shear_stiffness, 2 * s1 * s2 / (s1 + s2));
}

TEST(LinearCouple, OfEqualMaterialsIsTheLimitOfDifferingOnes) {
  const Linear::Material one{5e8, 0.3, 0.5, {}, {}, {}};
  Linear::Material other = one;
  other.young_modulus *= 1 + 1e-12;
  const Kinematics<double> k = unequal();
  ContactHistory<double> history{};
  ContactEnergies<double> energies;
  const auto equal = Linear::respond(Linear::mix(one, one), k, 0.0, history, energies);
  const auto differing = Linear::respond(Linear::mix(one, other), k, 0.0, history, energies);
  EXPECT_NEAR(equal.normal_stiffness / differing.normal_stiffness, 1, 1e-11);
  EXPECT_NEAR(equal.shear_stiffness / differing.shear_stiffness, 1, 1e-11);
}

TEST(LawWithoutShearOrResistance, LetsGoOfForcesThatAStateWasMadeWith) {
  const Linear::Material smooth{5e8, 0, 0.5, {}, {}, {}};
  Kinematics<double> k{};
  k.normal = {0, 0, 1};
  k.overlap = 1e-5;
  k.r1 = k.r2 = 1e-3, k.R_star = 5e-4, k.per_reach = 500, k.m1 = k.m2 = 1e-5;
  ContactHistory<double> history{{0.1, 0.2, 0}, {1e-4, 0, 0}, 1e-4};
  ContactEnergies<double> energies;
  const auto r = Linear::respond(Linear::mix(smooth, smooth), k, 1e-6, history, energies);
  EXPECT_GT(r.normal_force, 0);
  EXPECT_EQ(norm(history.shear), 0);
  EXPECT_EQ(norm(history.rolling), 0);
  EXPECT_EQ(history.twisting, 0);
  EXPECT_EQ(energies.elastic_shear + energies.elastic_rolling + energies.elastic_twisting, 0);
  EXPECT_EQ(energies.frictional, 0);
}

TEST(DampingRatio, InvertsTheRestitution) {
  for (const bool attraction : {false, true})
    for (const double e : {0.01, 0.1, 0.2, 0.5, 0.9, 0.999})
      EXPECT_NEAR(restitution(damping_ratio(e, attraction), attraction), e, 1e-12) << e << attraction;
  EXPECT_EQ(damping_ratio(1, false), 0);
}

TEST(DampingRatio, IsContinuousAtTheCriticalOne) {
  const double critical = std::exp(-2.0);
  for (const double step : {-1e-6, -1e-13, 0.0, 1e-13, 1e-6})
    EXPECT_NEAR(restitution(1 + step, false), critical, 2e-6) << step;
  EXPECT_EQ(restitution(1, true), 0);
}

TEST(DampingRatio, CutAtSeparationNeedsMoreOfItThanWithAttraction) {
  for (const double e : {0.2, 0.5, 0.8}) EXPECT_GT(damping_ratio(e, false), damping_ratio(e, true));
}

TEST(Lanes, DoInEachLaneWhatADoubleDoes) {
  const Lane4 a{-1, 2, 0, 9}, b{3, -4, 0, 1};
  const Lane4 big = maximum(a, b), small = minimum(a, b), size = absolute(a), root = square_root(absolute(b));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(big[i], maximum(a[i] + 0, b[i] + 0));
    EXPECT_EQ(small[i], minimum(a[i] + 0, b[i] + 0));
    EXPECT_EQ(size[i], absolute(a[i] + 0));
    EXPECT_EQ(root[i], std::sqrt(std::abs(b[i])));
  }
  const V3<Lane4> v{a, b, a};
  EXPECT_EQ(lane(select(a > b, v, broadcast<Lane4>(-1) * v), 1).y, -4);
}

}  // namespace
}  // namespace soilweave::dem
