// Design agrees with the response it is inverted from; sensitivities and bands agree with their sources.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "gws/design/design.h"
#include "gws/design/sensitivity.h"
#include "gws/solution/data_sheet.h"
#include "gws/solution/root.h"
#include "gws/solution/secant.h"
#include "support/gws_reference.h"

namespace soilweave::gws {
namespace {

const StiffnessRange range{1e3, 1e8};

Case nothing_yet() { return test::bag_of(0, 0, 0); }

TEST(GwsDesign, TheDesignedBagSettlesAsAdmittedAndFailsAtTheSafety) {
  for (const double surcharge : {50e3, 300e3, 1000e3})
    for (const double settlement : {0.04, 0.08})
      for (const double lateral : {0.0, 10e3}) {
        const Demand demand{surcharge, settlement, 1.5};
        Case bag = nothing_yet();
        if (lateral > 0) bag.lateral = LateralStress::constant(lateral);
        const Design design = smallest_geotextile(bag, demand, range);
        bag.geotextile = design.geotextile;
        bag.geotextile.failure_strain = 1;
        const Response response(bag);
        EXPECT_NEAR(response.at_surcharge(surcharge).settlement() / settlement, 1, 1e-3) << surcharge;
        EXPECT_NEAR(response.last().surcharge / (1.5 * surcharge), 1, 1e-3) << surcharge;
        EXPECT_EQ(design.governs, Governs::settlement);
      }
}

TEST(GwsDesign, GeotextilesOfOneKindAreHeldToTheirStrength) {
  const Demand demand{300e3, 0.05, 4};
  Case bag = test::bag_of("PP");
  const Design design = smallest_geotextile(bag, demand, range);
  EXPECT_EQ(design.governs, Governs::strength);
  EXPECT_NEAR(design.geotextile.strength / design.geotextile.stiffness, 31.754 / 232, 1e-9);
  bag.geotextile = design.geotextile;
  const Response response(bag);
  EXPECT_NEAR(response.last().surcharge / 1200e3, 1, 1e-3);
  EXPECT_LT(response.at_surcharge(300e3).settlement(), 0.05);
}

TEST(GwsDesign, CompactionCountsSettlementFromThere) {
  Case bag = nothing_yet();
  bag.initial_surcharge = 50e3;
  const Design design = smallest_geotextile(bag, {300e3, 0.03, 1}, range);
  bag.geotextile = design.geotextile;
  bag.geotextile.failure_strain = 1;
  const Response response(bag);
  EXPECT_NEAR((response.at_surcharge(300e3).settlement() - response.start().settlement()) / 0.03, 1, 1e-3);
}

TEST(GwsDesign, TheAllowableSurchargeIsTheLesserOfTheTwo) {
  const Case bag = test::bag_of("PP");
  const Response response(bag);
  const Allowance by_settlement = allowable_surcharge(bag, 0.05, 1.5),
                  by_strength = allowable_surcharge(bag, 0.12, 1.5);
  EXPECT_EQ(by_settlement.governs, Governs::settlement);
  EXPECT_NEAR(response.at_surcharge(by_settlement.surcharge).settlement(), 0.05, 1e-9);
  EXPECT_EQ(by_strength.governs, Governs::strength);
  EXPECT_NEAR(by_strength.surcharge, response.last().surcharge / 1.5, 1e-6);
}

/// Returns bags with data sheets: one that is slack at first, and one that is stiff at first.
std::vector<Case> bags_of_sheets() {
  std::vector<Case> bags(2, nothing_yet());
  bags[0].geotextile = of_sheet("slack", {2e3, 8e3, 60e3, 0.1}, "here");
  bags[1].geotextile = of_sheet("stiff", {20e3, 40e3, 60e3, 0.1}, "here");
  return bags;
}

/// Returns the settlement of a bag under a surcharge, as `respond` finds it.
double settlement_under(Case bag, double surcharge) {
  bag = at_strain_reached(bag, surcharge);
  bag.until = surcharge;
  const Response response(bag);
  EXPECT_FALSE(response.failed());
  return response.last().settlement() - response.start().settlement();
}

TEST(GwsDesign, TheAnswerForADataSheetSettlesAsAskedInTheResponse) {
  for (const std::optional<double> compacted : {std::optional<double>(), std::optional<double>(30e3)})
    for (Case bag : bags_of_sheets()) {
      bag.initial_surcharge = compacted;
      const Allowance allowed = allowable_surcharge(bag, 0.04, 1.2);
      ASSERT_EQ(allowed.governs, Governs::settlement);
      EXPECT_NEAR(settlement_under(bag, allowed.surcharge), 0.04, 1e-6) << bag.geotextile.name;
      const Design design = smallest_geotextile(bag, {300e3, 0.04, 1.2}, range);
      Case designed = bag;
      designed.geotextile = design.geotextile;
      EXPECT_NEAR(settlement_under(designed, 300e3), 0.04, 1e-6) << bag.geotextile.name;
      EXPECT_NEAR(design.service.hoop_tension / design.service.hoop_strain, design.geotextile.stiffness, 1);
      // Only the tensions were scaled, all alike.
      EXPECT_NEAR(design.geotextile.curve.tension[1] / bag.geotextile.curve.tension[1],
                  design.geotextile.strength / bag.geotextile.strength, 1e-12);
      const double J = at_strain_reached(bag, std::nullopt).geotextile.stiffness;
      const ChartRow row = design_chart(bag, {300e3, 0.04, 1.2}, {J, 2 * J}, 2).front();
      EXPECT_NEAR(row.service_settlement, settlement_under(bag, 300e3), 1e-6);
      EXPECT_NEAR(row.allowable_surcharge / allowed.surcharge, 1, 1e-6);
    }
}

TEST(GwsDesign, TheStrengthOfADataSheetGovernsAtTheSafety) {
  for (const Case& bag : bags_of_sheets()) {
    const Design design = smallest_geotextile(bag, {1000e3, 0.3, 1.5}, range);
    EXPECT_EQ(design.governs, Governs::strength);
    Case designed = bag;
    designed.geotextile = design.geotextile;
    EXPECT_NEAR(Response(at_strain_reached(designed, std::nullopt)).last().surcharge / 1500e3, 1, 1e-6);
  }
}

TEST(GwsDesign, TheSettlementGovernsOnlyWhereItIsReached) {
  // Hoops without a limit of their own: a softer bag has no state at the surcharge, long before it is flat.
  for (const double settlement : {0.9, 1.0}) {
    const Design design = smallest_geotextile(nothing_yet(), {300e3, settlement, 1}, range);
    EXPECT_EQ(design.governs, Governs::end);
    EXPECT_EQ(design.end, End::unstable);
    EXPECT_LT(design.service.settlement(), 0.6);
  }
  for (const Case& bag : bags_of_sheets())
    for (const double settlement : {0.9, 1.0})
      EXPECT_EQ(smallest_geotextile(bag, {300e3, settlement, 1}, range).governs, Governs::strength);
  EXPECT_EQ(smallest_geotextile(test::bag_of("PP"), {300e3, 1, 1}, range).governs, Governs::strength);
  const Allowance flat = allowable_surcharge(test::bag_of(20e3, 40e3, 2), 0.9, 2);
  EXPECT_EQ(flat.governs, Governs::end);
  EXPECT_EQ(flat.end, End::collapse);
}

TEST(GwsSensitivity, ADataSheetIsVariedAsItResponds) {
  for (Case bag : bags_of_sheets()) {
    bag = at_strain_reached(bag, 300e3);
    bag.until = 300e3;
    for (const Sensitivity& row : sensitivities(bag, {"test", bag.soil, {}}, 0.1)) {
      if (row.key != "height") continue;
      Case low = bag, high = bag;
      low.bag.height *= 0.9, high.bag.height *= 1.1;
      EXPECT_NEAR(row.service_settlement_low, settlement_under(low, 300e3), 1e-6);
      EXPECT_NEAR(row.service_settlement_high, settlement_under(high, 300e3), 1e-6);
    }
    // Constants without scatter give bands without width.
    const Bands bands = monte_carlo(bag, {"test", bag.soil, {{{"near_failure_line.xi"}, {0}, {1}, 10}}}, 2, 1, 3);
    const BandRow& middle = bands.rows[1];
    EXPECT_NEAR(settlement_under(bag, middle.surcharge.middle), middle.settlement, 1e-6);
  }
}

TEST(GwsDesign, AStrainAtFailureAloneLimitsTheHoops) {
  for (const double failure_strain : {0.02, 0.1}) {
    Case bag = test::bag_of(0, 0, failure_strain);
    const Design design = smallest_geotextile(bag, {300e3, 0.05, 1.5}, range);
    EXPECT_NEAR(design.geotextile.strength / design.geotextile.stiffness, failure_strain, 1e-12);
    EXPECT_LE(design.factored.hoop_strain, bag.strength_fraction * failure_strain * (1 + 1e-9));
    EXPECT_EQ(design.governs, failure_strain < 0.05 ? Governs::strength : Governs::settlement);
    bag.geotextile = design.geotextile;
    EXPECT_GE(Response(bag).last().surcharge, 450e3 * (1 - 1e-6));
  }
}

TEST(GwsDesign, NumbersThatDescribeNoKindAreRefused) {
  for (const Case& bag : {test::bag_of(0, 10e3, 0), test::bag_of(0, 10e3, 0.1), test::bag_of(200e3, 0, 0)})
    EXPECT_THROW(smallest_geotextile(bag, {300e3, 1, 1}, range), DataError);
}

TEST(GwsRoot, AFunctionThatIsNotFiniteHasNoRoot) {
  const auto close = [](double a, double b) { return std::abs(b - a) < 1e-9; };
  const auto broken = [](double x) { return x < 0.5 ? -1 : std::nan(""); };
  EXPECT_THROW(root_between(broken, 0, 1, -1, 1, close), DataError);
  EXPECT_THROW(
      root_between([](double x) { return x < 0.3 ? -1.0 : 1.0; }, 0, 1, -1, 1, [](double, double) { return false; }),
      DataError);
}

TEST(GwsDesign, WhatNoStiffnessCarriesIsSaid) {
  EXPECT_THROW(smallest_geotextile(nothing_yet(), {300e3, 0.001, 1}, range), TargetNotReached);
  EXPECT_THROW(smallest_geotextile(nothing_yet(), {1e3, 0.1, 1}, range), DataError);
  EXPECT_THROW(smallest_geotextile(nothing_yet(), {300e3, 0.1, 0.5}, range), DataError);
}

TEST(GwsDesign, ASoilWithoutStatesUnderTheStiffestGeotextileHasItsSmallestOne) {
  // A soil of grains: its response ends at 116 kPa under 2 MN/m, and goes on without end under 1 MN/m.
  Case bag = nothing_yet();
  Soil& soil = bag.soil;
  soil.C_t = 0.833, soil.p_0 = 5574, soil.n = 0.064264, soil.p_c = 94226;
  soil.kappa = 0.71884, soil.lambda = 0.97434, soil.xi = -0.13805, soil.alpha = 16.96e6, soil.beta = 0.79063;
  const auto settlement = [&](double stiffness) {
    Case loaded = bag;
    loaded.geotextile.stiffness = stiffness;
    loaded.geotextile.strength = loaded.geotextile.failure_strain = 1e9;
    loaded.until = 313e3;
    const Response response(loaded);
    return response.failed() ? 1 : response.last().settlement();
  };
  ASSERT_EQ(settlement(2e6), 1);
  const Design design = smallest_geotextile(bag, {313e3, 0.05, 1}, range);
  EXPECT_NEAR(settlement(design.geotextile.stiffness), 0.05, 1e-5);
  EXPECT_GT(settlement(0.99 * design.geotextile.stiffness), 0.05);
}

TEST(GwsDesign, AChartIsTheResponsesOfItsBags) {
  const auto rows = design_chart(test::bag_of("PP"), {300e3, 0.06, 2}, {232e3, 5 * 232e3}, 5);
  ASSERT_EQ(rows.size(), 5u);
  const Response one(test::bag_of("PP")), five(test::bag_of("5PP"));
  EXPECT_NEAR(rows[0].capacity / one.last().surcharge, 1, 1e-9);
  EXPECT_NEAR(rows[4].capacity / five.last().surcharge, 1, 1e-9);
  EXPECT_NEAR(rows[4].settlement / five.last().settlement(), 1, 1e-9);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    // Thesis section 5.4.2: weak geotextiles reinforce more efficiently.
    EXPECT_LT(rows[i].capacity / rows[i].geotextile.stiffness, rows[i - 1].capacity / rows[i - 1].geotextile.stiffness);
    EXPECT_LT(rows[i].service_settlement, rows[i - 1].service_settlement);
  }
}

TEST(GwsSensitivity, DerivativesAreThoseOfTheResponse) {
  const Case bag = test::bag_of("PP");
  const auto rows = sensitivities(bag, {"test", bag.soil, {}}, 0.1);
  EXPECT_EQ(rows.size(), constants().size() + 5);
  for (const Sensitivity& row : rows) {
    if (row.key != "geotextile.strength") continue;
    // A wider second-order difference quotient, with two settlements per strength, serves as reference.
    Case low = bag, high = bag;
    low.geotextile.strength *= 0.99;
    high.geotextile.strength *= 1.01;
    const double slope =
        (Response(high).last().surcharge - Response(low).last().surcharge) / (0.02 * bag.geotextile.strength);
    EXPECT_NEAR(row.capacity_derivative, slope, 1e-3 * slope);
    const double settling =
        (Response(high).last().settlement() - Response(low).last().settlement()) / (0.02 * bag.geotextile.strength);
    EXPECT_NEAR(row.settlement_derivative, settling, 1e-3 * settling);
    EXPECT_NEAR(row.low, 0.9 * bag.geotextile.strength, 1e-6);
    EXPECT_LT(row.capacity_low, row.capacity_high);
  }
}

TEST(GwsSensitivity, BandsOfAKnownScatterHaveItsWidth) {
  // Only xi scatters, so little that the capacity is linear in it: quantiles follow the t distribution.
  const Case bag = test::bag_of("PP");
  const double error = 1e-4;
  const SoilFile soil{"test", bag.soil, {{{"near_failure_line.xi"}, {error}, {1}, 1e6}}};
  const Bands bands = monte_carlo(bag, soil, 4000, 7, 4);
  double slope = 0;
  for (const Sensitivity& row : sensitivities(bag, soil, 0.1))
    if (row.key == "near_failure_line.xi") slope = row.capacity_derivative;
  // The error of a quantile of 2.5 % from 4000 draws is about 3.5 % of the half width.
  EXPECT_NEAR((bands.capacity.high - bands.capacity.low) / (2 * 1.96 * error * slope), 1, 0.08);
  EXPECT_NEAR(bands.capacity.middle, Response(bag).last().surcharge, 3 * error * slope / std::sqrt(1000.0));
  EXPECT_TRUE(bands.left_out.empty());
  ASSERT_EQ(bands.rows.size(), 5u);
  const Bands again = monte_carlo(bag, soil, 4000, 7, 4);
  EXPECT_EQ(again.capacity.low, bands.capacity.low);
}

TEST(GwsSensitivity, DrawsOutOfRangeAreCounted) {
  const Case bag = test::bag_of("PP");
  const SoilFile soil{"test", bag.soil, {{{"stiffness.poisson_ratio"}, {0.2}, {1}, 1e6}}};
  const Bands bands = monte_carlo(bag, soil, 200, 7, 2);
  std::size_t left_out = 0;
  for (const auto& [why, count] : bands.left_out) left_out += count;
  EXPECT_GT(left_out, 20u);
  EXPECT_EQ(bands.samples + left_out, 200u);
  EXPECT_EQ(bands.varied, std::vector<std::string>{"stiffness.poisson_ratio"});
  EXPECT_EQ(bands.held.size(), constants().size() - 1);
  EXPECT_TRUE(bands.left_out.contains("stiffness.poisson_ratio out of its range"));
  EXPECT_THROW(monte_carlo(bag, {"test", bag.soil, {}}, 10, 1, 2), DataError);
}

}  // namespace
}  // namespace soilweave::gws
