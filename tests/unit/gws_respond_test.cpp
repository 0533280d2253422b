// Responses against the reference curves and the discrete-element series, error control, and refusals.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "gws/solution/respond.h"
#include "support/gws_reference.h"

namespace soilweave::gws {
namespace {

using test::bag_of;

struct Expected {
  const char* name;
  double ultimate, settlement;       // kPa and %, to the digits of the reference
  double lateral, axial, surcharge;  // RMS from the discrete elements, % of their maximum, as tabulated
  double excess_low, excess_high;    // excess of the ultimate surcharge over the discrete elements
};
constexpr Expected expected[] = {{"PE", 585, 11.67, 4.0, 3.8, 8.9, 0.20, 0.25},
                                 {"PP", 1731, 12.50, 1.4, 2.1, 6.3, 0.20, 0.25},
                                 {"3PP", 4862, 15.65, 0.9, 2.0, 7.0, 0.20, 0.25}};

TEST(GwsRespond, MeetsTheReferenceCurves) {
  for (const Expected& e : expected) {
    const test::Columns curve = test::reference_table(std::string("ch5/ref_model_uc_") + e.name + ".csv");
    if (curve.empty()) GTEST_SKIP() << "no SOILWEAVE_REFERENCE";
    const Response response(bag_of(e.name));
    EXPECT_NEAR(response.last().surcharge / 1e3, e.ultimate, 0.5) << e.name;
    EXPECT_NEAR(100 * response.last().settlement(), e.settlement, 0.005) << e.name;
    EXPECT_EQ(response.end(), End::strength);
    const auto& load = curve.at("sigma_as_kPa");
    ASSERT_GT(load.size(), 100u);
    for (std::size_t i = 0; i < load.size(); ++i) {
      // The reference's last row is a whole increment past the limit, by at most 1/20 000 of the range.
      const double surcharge = std::min(1e3 * load[i], response.last().surcharge);
      ASSERT_GT(surcharge, 1e3 * load[i] * 0.9999);
      const Point at = response.at_surcharge(surcharge);
      EXPECT_NEAR(at.soil.strain_axial, curve.at("eps_a_pct")[i], 0.01) << e.name << " " << load[i];
      EXPECT_NEAR(at.soil.strain_radial, curve.at("eps_r_pct")[i], 0.01) << e.name << " " << load[i];
      EXPECT_NEAR(100 * at.hoop_strain, curve.at("eps_h_pct")[i], 0.01) << e.name << " " << load[i];
      EXPECT_NEAR(at.soil.axial_stress() / 1e3, curve.at("sigma_a_kPa")[i], 0.005 * curve.at("sigma_a_kPa")[i]);
      EXPECT_NEAR(at.soil.lateral_stress() / 1e3, curve.at("sigma_r_kPa")[i], 0.005 * curve.at("sigma_r_kPa")[i]);
      const double strain = std::min(curve.at("eps_a_pct")[i] / 100, response.last().settlement());
      EXPECT_NEAR(response.at_strain(strain).surcharge / 1e3, load[i], 0.005 * load[i]) << e.name;
    }
  }
}

/// Returns the root mean square of model minus series at equal axial strain, in percent of the series' greatest value.
template <class Model>
double misfit(const std::vector<double>& series, std::size_t rows, const Model& model) {
  double squares = 0, greatest = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    squares += (model(i) - series[i]) * (model(i) - series[i]) / static_cast<double>(rows);
    greatest = std::max(greatest, series[i]);
  }
  return 100 * std::sqrt(squares) / greatest;
}

TEST(GwsRespond, IsAsNearToTheDiscreteElementsAsTheReference) {
  for (const Expected& e : expected) {
    const test::Columns dem = test::reference_table(std::string("ch5/dem_uc_") + e.name + ".csv");
    if (dem.empty()) GTEST_SKIP() << "no SOILWEAVE_REFERENCE";
    const auto& strain = dem.at("eps_a_pct");
    const auto& load = dem.at("sigma_as_kPa");
    const auto peak = static_cast<std::size_t>(std::max_element(load.begin(), load.end()) - load.begin());
    Case bag = bag_of(e.name);
    bag.strength_fraction = 0.6;  // the discrete elements of PE end a little later than the model
    const Response response(bag);
    const auto at = [&](std::size_t i) { return response.at_strain(std::max(strain[i], 1e-9) / 100); };
    std::vector<double> lateral;
    for (std::size_t i = 0; i <= peak; ++i)
      lateral.push_back((dem.at("sigma_x_kPa")[i] + dem.at("sigma_y_kPa")[i]) / 2);
    const double rounding = 0.05;  // half of the last digit given
    EXPECT_LE(misfit(lateral, peak + 1, [&](std::size_t i) { return at(i).soil.lateral_stress() / 1e3; }),
              e.lateral + rounding)
        << e.name;
    EXPECT_LE(misfit(dem.at("sigma_z_kPa"), peak + 1, [&](std::size_t i) { return at(i).soil.axial_stress() / 1e3; }),
              e.axial + rounding)
        << e.name;
    EXPECT_LE(misfit(load, peak + 1, [&](std::size_t i) { return at(i).surcharge / 1e3; }), e.surcharge + rounding)
        << e.name;
    const double excess = Response(bag_of(e.name)).last().surcharge / 1e3 / load[peak] - 1;
    EXPECT_GE(excess, e.excess_low) << e.name;
    EXPECT_LE(excess, e.excess_high) << e.name;
  }
}

TEST(GwsRespond, SettlementsOrderAsTheThesisSays) {
  double before = 0;
  for (const char* name : {"PE", "0.5PP", "PP", "2PP", "3PP", "4PP", "5PP"}) {
    const Response response(bag_of(name));
    EXPECT_GT(response.last().surcharge, before) << name;
    before = response.last().surcharge;
  }
  EXPECT_LT(Response(bag_of("PP")).last().settlement(), Response(bag_of("3PP")).last().settlement());
}

TEST(GwsRespond, TriaxialStartsAreTheReferenceS) {
  // sigma_rs = 10, 50, 100 kPa: 7.50, 20.84, 37.50 kPa; hoops begin in compression, at -6.2 % for PE under 100 kPa.
  const double starts[][2] = {{10e3, 7.50}, {50e3, 20.84}, {100e3, 37.50}};
  for (const auto& [lateral, start] : starts) {
    Case bag = bag_of("PE");
    bag.lateral = LateralStress::constant(lateral);
    const Response response(bag);
    EXPECT_NEAR(response.start().surcharge / 1e3, start, 0.005);
    EXPECT_LT(response.start().hoop_strain, 0);
    EXPECT_EQ(response.end(), End::strength);
    if (lateral == 100e3) {
      EXPECT_NEAR(100 * response.start().hoop_strain, -6.2, 0.05);
    }
  }
}

TEST(GwsRespond, HalvingTheToleranceChangesLessThanTheTolerance) {
  for (const char* name : {"PE", "PP", "5PP"})
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
      Case coarse = bag_of(name);
      coarse.tolerance = tolerance;
      Case fine = coarse;
      fine.tolerance = tolerance / 2;
      const Point one = Response(coarse).last(), other = Response(fine).last();
      EXPECT_LT(std::abs(one.surcharge / other.surcharge - 1), tolerance) << name << " " << tolerance;
      EXPECT_LT(std::abs(one.settlement() / other.settlement() - 1), tolerance) << name << " " << tolerance;
    }
}

TEST(GwsRespond, AHistoryOfOneStressIsThatStress) {
  Case constant = bag_of("PP"), history = constant;
  constant.lateral = LateralStress::constant(30e3);
  history.lateral = {{0, 100e3, 1e6}, {30e3, 30e3, 30e3}};
  EXPECT_NEAR(Response(constant).last().surcharge, Response(history).last().surcharge, 1e-6);
}

TEST(GwsRespond, AHistoryIsStraightBetweenItsRowsAndLevelBeyondThem) {
  const LateralStress history{{10e3, 30e3, 50e3}, {5e3, 9e3, 8e3}};
  const double expected[][2] = {{1e3, 5e3},    {10e3, 5e3}, {25e3, 8e3}, {30e3, 9e3},
                                {40e3, 8.5e3}, {50e3, 8e3}, {1e6, 8e3}};
  for (const auto& [load, lateral] : expected) EXPECT_DOUBLE_EQ(history.at(load), lateral) << load;
  EXPECT_EQ(LateralStress().at(1e5), 0);
}

TEST(GwsRespond, AHistoryIsFollowedAndBalanced) {
  Case bag = bag_of("PP");
  bag.lateral = {{20e3, 500e3}, {0, 100e3}};
  const Response response(bag);
  for (const double surcharge : {10e3, 100e3, 400e3, 900e3}) {
    const Point at = response.at_surcharge(surcharge);
    EXPECT_NEAR(at.lateral, bag.lateral.at(surcharge), 1e-6 * surcharge);
    EXPECT_NEAR(gws::surcharge(bag.bag, at.soil, at.lateral), surcharge, 1e-9 * surcharge);
  }
}

TEST(GwsRespond, CompactionShiftsTheBeginningAndNothingElse) {
  const Case bag = bag_of("PP");
  const Response whole(bag);
  Case by_settlement = bag, by_pressure = bag;
  by_settlement.initial_settlement = 0.02;
  const Response compacted(by_settlement);
  EXPECT_NEAR(compacted.start().settlement(), 0.02, 1e-12);
  EXPECT_DOUBLE_EQ(compacted.last().surcharge, whole.last().surcharge);
  by_pressure.initial_surcharge = compacted.start().surcharge;
  EXPECT_NEAR(Response(by_pressure).start().settlement(), 0.02, 1e-9);
  EXPECT_THROW(compacted.at_strain(0.01), DataError);
}

TEST(GwsRespond, PointsAreEqualStepsOfSettlement) {
  const Response response(bag_of("PE"));
  const auto points = response.points(10);
  ASSERT_EQ(points.size(), 11u);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_NEAR(points[i].settlement() - points[i - 1].settlement(), response.last().settlement() / 10, 1e-9);
}

/// Returns the message of the DataError for the bag.
std::string refusal(const Case& bag) {
  try {
    const Response response(bag);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(GwsRespond, RefusesWhatIsInadmissibleWithRangeAndReason) {
  const auto changed = [](const auto& change) {
    Case bag = bag_of("PP");
    change(bag);
    return refusal(bag);
  };
  EXPECT_EQ(
      changed([](Case& c) { c.geotextile.stiffness = -1; }),
      "stiffness: -1 is out of range: must be between 0 and 1e10 N/m (without stiffness the geotextile holds nothing)");
  EXPECT_EQ(changed([](Case& c) { c.bag.height = 0; }),
            "height: 0 is out of range: must be between 0 and 100 m (a bag has an extent; millimetres are written "
            "\"400 mm\")");
  EXPECT_EQ(
      changed([](Case& c) { c.soil.poisson_ratio = 0.5; }),
      "stiffness.poisson_ratio: 0.5 is out of range: must be between -1 and 0.5 (at 0.5 the soil is incompressible, "
      "below -1 it is unstable)");
  EXPECT_EQ(
      changed([](Case& c) { c.until = 4000; }),
      "surcharge: 4000 Pa is below the initial one, 4169.3 Pa (mean stress 2600 Pa); the model has no state there");
  EXPECT_NE(changed([](Case& c) { c.soil.kappa = std::nan(""); }).find("near_failure_line.kappa"), std::string::npos);
  EXPECT_NE(changed([](Case& c) { c.initial_settlement = 0.5; }).find("initial settlement: 0.5 is not below"),
            std::string::npos);
  EXPECT_NE(changed([](Case& c) { c.lateral = {{0, 10}, {0, 100}}; }).find("loaded from its sides"), std::string::npos);
  EXPECT_NE(changed([](Case& c) { c.lateral = {{10, 10}, {0, 0}}; }).find("cannot unload"), std::string::npos);
  EXPECT_NE(changed([](Case& c) { c.geotextile.strength = 1; }).find("fails under the first stress"),
            std::string::npos);
  EXPECT_NE(changed([](Case& c) { c.soil.M = 0.01; }).find("its constants allow no state"), std::string::npos);
}

TEST(GwsRespond, EndsWithTheFailureStrainWhereThatComesFirst) {
  Case bag = bag_of("PP");
  bag.geotextile.failure_strain = 0.03;
  const Response response(bag);
  EXPECT_EQ(response.end(), End::failure_strain);
  EXPECT_NEAR(response.last().hoop_strain, 0.03, 1e-12);
}

}  // namespace
}  // namespace soilweave::gws
