// Round trips: bags made by the solution, with and without errors, give back the constants that they were made with.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "files/exchange/table.h"
#include "gws/identification/bag_runs.h"
#include "gws/identification/identify.h"
#include "gws/solution/respond.h"
#include "support/gws_reference.h"

namespace soilweave::gws {
namespace {

constexpr const char* seven[] = {"PE", "0.5PP", "PP", "2PP", "3PP", "4PP", "5PP"};

/// Errors that are correlated from row to row. Grains that have rearranged stay where they are for some per cent of
/// strain, so a row above the line is followed by others above it. White errors would flatter the intervals.
class Errors {
 public:
  Errors(double deviation, double correlation, std::mt19937_64& random)
      : deviation_(deviation), correlation_(correlation), random_(random), last_(deviation * normal_(random)) {}
  double next() {
    last_ = correlation_ * last_ + deviation_ * std::sqrt(1 - correlation_ * correlation_) * normal_(random_);
    return last_;
  }

 private:
  double deviation_, correlation_;
  std::mt19937_64& random_;
  std::normal_distribution<double> normal_;
  double last_;
};

struct Noise {
  double stress = 0, strain = 0, correlation = 0;  // relative; absolute; from row to row
};

BagSeries made(const std::string& name, const Soil& soil, std::size_t rows, const Noise& noise,
               std::mt19937_64& random) {
  Case bag = test::bag_of(name);
  bag.soil = soil;
  BagSeries series;
  series.name = name;
  series.stiffness = bag.geotextile.stiffness;
  Errors p(noise.stress, noise.correlation, random), q(noise.stress, noise.correlation, random),
      strain(noise.strain, noise.correlation, random);
  for (const Point& point : Response(bag).points(rows)) {
    const bool first = series.size() == 0;  // strains count from the first row, which has no error of its own
    const double offset = strain.next();
    series.mean_stress.push_back(point.soil.p * (1 + p.next()));
    series.deviatoric_stress.push_back(point.soil.p * point.soil.obliquity * (1 + q.next()));
    series.strain_axial.push_back(point.settlement());
    series.strain_volumetric.push_back(point.soil.strain_volumetric / 100 + (first ? 0 : offset));
  }
  return series;
}

Identification identified(const std::vector<BagSeries>& series) {
  return identify(series, {"test", {}, {}}, {}, {}, Difference::central, Method::path);
}

/// Returns the constants whose interval does not hold the true value.
std::vector<std::string> missed(const Identification& found, const Soil& truth) {
  std::vector<std::string> keys;
  for (const Line& line : found.lines)
    for (std::size_t k = 0; k < line.constants.size(); ++k) {
      const double value = truth.*constant(line.constants[k]).field;
      if (!(std::abs(line.fit.estimates[k] - value) <= line.fit.half_width(k))) keys.push_back(line.constants[k]);
    }
  return keys;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + " ";
  return text;
}

TEST(GwsPathFit, AResponseIdentifiedAgainHasItsConstantsInsideAndNoOutlier) {
  std::mt19937_64 random(1);
  Soil other;  // identification begins at Table 5.2, these bags were made with other constants
  other.C_t = 0.9, other.p_0 = 3e3, other.kappa = 1.6, other.lambda = 1.5, other.p_1 = 1.4, other.p_2 = 0.3;
  for (const Soil& soil : {Soil{}, other})
    for (const char* name : {"PE", "PP", "3PP"})
      for (const std::size_t rows : {12u, 20u}) {
        const Identification found = identified({made(name, soil, rows, {}, random)});
        ASSERT_EQ(found.lines.size(), 3u) << name << " " << rows << " " << joined(found.left_out);
        EXPECT_EQ(joined(missed(found, soil)), "") << name << " " << rows;
        EXPECT_NEAR(found.soil.soil.C_t, soil.C_t, 1e-3 * soil.C_t) << name << " " << rows;
        EXPECT_NEAR(found.soil.soil.p_1, soil.p_1, 1e-3 * soil.p_1) << name << " " << rows;
        for (const Line& line : found.lines)
          for (const double t : line.fit.studentized) EXPECT_LT(std::abs(t), outlier_distance) << line.name;
      }
}

TEST(GwsPathFit, BagsOfSeveralStiffnessesGiveTheStiffnessAsWell) {
  std::mt19937_64 random(1);
  Soil other;
  other.alpha = 20e6, other.beta = 0.8;
  const Identification found = identified(
      {made("PE", other, 20, {}, random), made("PP", other, 20, {}, random), made("3PP", other, 20, {}, random)});
  ASSERT_EQ(found.lines.size(), 4u) << joined(found.left_out);
  EXPECT_EQ(joined(missed(found, other)), "");
  EXPECT_NEAR(found.soil.soil.alpha, 20e6, 1e-3 * 20e6);
  EXPECT_NEAR(found.soil.soil.beta, 0.8, 1e-3);
}

TEST(GwsPathFit, IntervalsOfNoisyBagsHoldTheConstantsIn85Of100Repetitions) {
  const Soil soil;
  std::map<std::string, int> outside;
  std::size_t constants = 0;
  for (unsigned repetition = 0; repetition < 100; ++repetition) {
    std::mt19937_64 random(repetition);
    std::vector<BagSeries> series;
    for (const char* name : seven) series.push_back(made(name, soil, 12, {0.01, 3e-4, 0.5}, random));
    const Identification found = identified(series);
    ASSERT_EQ(found.lines.size(), 4u) << joined(found.left_out);
    constants = 0;
    for (const Line& line : found.lines) constants += line.constants.size();
    for (const std::string& key : missed(found, soil)) ++outside[key];
  }
  EXPECT_EQ(constants, 9u);
  for (const auto& [key, count] : outside) {
    std::printf("[   info   ] %3d of 100 %s\n", 100 - count, key.c_str());
    EXPECT_LE(count, 15) << key;
  }
}

TEST(GwsPathFit, IntervalsHoldTheConstantsWhereOneMeasurementAloneHasErrors) {
  const Soil soil;
  std::map<std::string, int> outside;
  for (unsigned repetition = 0; repetition < 60; ++repetition) {
    std::mt19937_64 random(repetition);
    std::vector<BagSeries> series;
    for (const char* name : {"PE", "PP", "3PP"}) series.push_back(made(name, soil, 20, {0, 2e-4, 0}, random));
    for (const std::string& key : missed(identified(series), soil)) ++outside[key];
  }
  for (const auto& [key, count] : outside) EXPECT_LE(count, 6) << key;
}

TEST(GwsPathFit, TheWayOfTheThesisTakesPlasticStrainForElastic) {
  std::mt19937_64 random(1);
  const BagSeries bag = made("PP", {}, 2000, {}, random);
  const Identification found = identify({bag}, {"test", {}, {}}, {}, {}, Difference::central, Method::thesis);
  EXPECT_GT(found.soil.soil.C_t, 1.05 * Soil{}.C_t);
  EXPECT_NE(explained(Method::thesis), explained(Method::path));
}

TEST(GwsPathFit, ReinforcedSoilInACellServesTheNearFailureLineAlone) {
  // The first row is under the isotropic stress of the cell; the others lie on the line. Strains are natural.
  std::string text =
      "strain_axial_engineering [1]\tsoil_strain_volumetric [1]\tsoil_mean_stress [Pa]\tsoil_deviatoric_stress "
      "[Pa]\tbroken_yarns [1]\n0\t0\t1e4\t1e4\t0\n0\t0\t1e4\t1e2\t0\n";
  const Soil soil;
  for (int i = 1; i <= 8; ++i) {
    const double strain = 0.01 * i, volumetric = 0.002, p = 1e4 * (1 + 3 * i);
    const double eta =
        failure_obliquity(soil, p) + soil.xi - soil.kappa / (100 * strain - 100 * volumetric / 3 + soil.lambda);
    text += std::to_string(strain) + "\t" + std::to_string(-std::log1p(-volumetric)) + "\t" + std::to_string(p) + "\t" +
            std::to_string(p * eta) + "\t" + (i == 8 ? "1" : "0") + "\n";
  }
  const io::Series table = io::from_tsv(text, "cell.tsv");
  EXPECT_TRUE(is_reinforced(table));
  EXPECT_FALSE(is_loading(table));
  const BagSeries bag = bag_of_reinforced(table, "cell.tsv", {232e3, "of PP"});
  EXPECT_FALSE(bag.from_rest);
  EXPECT_EQ(bag.row.front(), 1u);
  EXPECT_EQ(bag.size(), 8u);  // the row with a broken yarn is left out
  const Identification found = identified({bag});
  ASSERT_EQ(found.lines.size(), 1u) << joined(found.left_out);
  EXPECT_EQ(found.lines[0].x.size(), 7u);  // the isotropic row is not near failure
  EXPECT_NEAR(found.soil.soil.kappa, soil.kappa, 1e-3);
  ASSERT_EQ(found.left_out.size(), 1u);
  EXPECT_NE(found.left_out[0].find("no series begins at rest"), std::string::npos);
  // With bags that begin at rest, the fit takes the rows of all three series.
  std::mt19937_64 random(1);
  const Identification both = identified({bag, made("PE", soil, 20, {}, random), made("PP", soil, 20, {}, random)});
  ASSERT_EQ(both.lines.size(), 4u) << joined(both.left_out);
  EXPECT_EQ(both.lines[1].x.size(), 7u + 21u + 21u);
  EXPECT_NEAR(both.soil.soil.kappa, soil.kappa, 1e-3);
}

}  // namespace
}  // namespace soilweave::gws
