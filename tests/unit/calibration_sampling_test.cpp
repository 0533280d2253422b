// Parameter sets: the radical inverse digit by digit, the tables of thesis chapter 2, the promises of each sequence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "calibration/ensemble.h"
#include "calibration/sampling.h"
#include "core/error.h"
#include "files/exchange/table.h"
#include "support/calibration_reference.h"
#include "support/reference.h"

namespace soilweave::calibration {
namespace {

TEST(Sampling, RadicalInverseMirrorsTheDigits) {
  EXPECT_EQ(radical_inverse(0, 2), 0);
  EXPECT_EQ(radical_inverse(6, 2), 0.375);                    // 110 -> 0.011
  EXPECT_DOUBLE_EQ(radical_inverse(5, 3), 7.0 / 9);           // 12 -> 0.21
  EXPECT_DOUBLE_EQ(radical_inverse(1999, 9), 1271.0 / 6561);  // 2661 in base 9 -> 0.1662
}

/// Returns the radical inverse by integers: digits collected, mirrored, divided once.
double mirrored(std::uint64_t index, std::uint64_t base) {
  std::uint64_t numerator = 0, denominator = 1;
  for (; index > 0; index /= base, denominator *= base) numerator = numerator * base + index % base;
  return static_cast<double>(numerator) / static_cast<double>(denominator);
}

TEST(Sampling, TheTableOfTheThesisHasItsBasesAndBeginsWithTheOrigin) {
  const std::vector<unsigned> bases = parse_bases("2,5,7,9,11");
  const Matrix points = halton(2000, bases, 0);
  EXPECT_EQ(points.row(0).norm(), 0);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (std::size_t k = 0; k < bases.size(); ++k)
      ASSERT_NEAR(points(i, static_cast<Eigen::Index>(k)), mirrored(static_cast<std::uint64_t>(i), bases[k]), 1e-15);
  const Prior prior = test::contact_prior({1e7, 0, 0, 0, 0}, {1e11, 0.5, 1, 1, 60});
  const Ensemble drawn = members_at(prior, points);
  EXPECT_EQ(drawn.values(0, 0), 1e7);
  EXPECT_NEAR(drawn.values(1, 0), 1e9, 1e-4);  // half of four decades
  EXPECT_DOUBLE_EQ(drawn.values(1, 3), 1.0 / 9);
  EXPECT_DOUBLE_EQ(drawn.values(1, 4), 60.0 / 11);
}

TEST(Sampling, TheTableOf100SetsAgreesInEveryPrintedDigit) {
  const auto table = soilweave::test::reference_table("ch2/mc100_parameters.csv");
  if (table.empty()) GTEST_SKIP() << "SOILWEAVE_REFERENCE is not set";
  const Prior prior = test::contact_prior({5.4e8, 0, 0.5, 0.1, 29}, {5.5e8, 0.2, 0.6, 0.2, 31});
  const Ensemble drawn = members_at(prior, halton(100, prime_bases(5), 1));
  ASSERT_EQ(table.at("sample").size(), drawn.size());
  const char* names[] = {"E_Pa", "nu", "kr", "eta", "mu_deg"};
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t k = 0; k < 5; ++k) {
      const double value = drawn.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
      char printed[32];
      std::snprintf(printed, sizeof printed, "%.6g", value);
      EXPECT_EQ(std::strtod(printed, nullptr), table.at(names[k])[i]) << "set " << i << ", " << names[k];
    }
}

TEST(Sampling, BasesThatShareAFactorOrAreNoneAreRefused) {
  EXPECT_EQ(prime_bases(5), (std::vector<unsigned>{2, 3, 5, 7, 11}));
  EXPECT_THROW(parse_bases("2,4"), UsageError);
  EXPECT_THROW(parse_bases("9,3"), UsageError);
  EXPECT_THROW(parse_bases("1"), UsageError);
  EXPECT_THROW(parse_bases("2,"), UsageError);
}

TEST(Sampling, SobolFillsEveryDyadicBoxOnce) {
  // 16 points from the origin on, two dimensions: a (0, 4, 2)-net has one point in each box of 2^-a x 2^-(4-a).
  const Matrix points = sobol(16, 2, 0);
  for (int a = 0; a <= 4; ++a) {
    std::set<std::pair<int, int>> boxes;
    for (Eigen::Index i = 0; i < 16; ++i)
      boxes.insert({static_cast<int>(points(i, 0) * (1 << a)), static_cast<int>(points(i, 1) * (1 << (4 - a)))});
    EXPECT_EQ(boxes.size(), 16u) << a;
  }
  EXPECT_EQ(sobol(5, 3, 3), sobol(8, 3, 0).bottomRows(5));
  EXPECT_THROW(sobol(1, 41, 0), DataError);
}

TEST(Sampling, ALatinHypercubeHasOnePointInEachSlice) {
  const Matrix points = latin_hypercube(50, 3, 7);
  for (Eigen::Index k = 0; k < 3; ++k) {
    std::set<int> slices;
    for (Eigen::Index i = 0; i < 50; ++i) slices.insert(static_cast<int>(points(i, k) * 50));
    EXPECT_EQ(slices.size(), 50u);
  }
  EXPECT_EQ(points, latin_hypercube(50, 3, 7));
  EXPECT_NE(points, latin_hypercube(50, 3, 8));
}

Prior read(const std::string& text) {
  Settings document = Settings::parse(text, "prior.toml");
  Prior prior = read_prior(document);
  document.finish();
  return prior;
}

std::string mistake(const std::string& text) {
  try {
    read(text);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(Prior, IsReadWithUnitsAndWrittenBack) {
  const Prior prior =
      read("[[parameter]]\nname = \"E\"\nunit = \"Pa\"\nscale = \"log\"\nlow = \"10 MPa\"\nhigh = 1e11\n");
  EXPECT_EQ(prior.ranges[0].low, 1e7);
  EXPECT_DOUBLE_EQ(prior.ranges[0].value(0.25), 1e8);
  EXPECT_DOUBLE_EQ(prior.ranges[0].coordinate(1e8), 0.25);
  EXPECT_EQ(prior.ranges[0].width(), 4);
  const Prior again = read(prior_text(prior));
  EXPECT_EQ(again.ranges[0].scale, Scale::log);
  EXPECT_EQ(again.ranges[0].high, 1e11);
}

TEST(Prior, WhatIsWrongIsSaidWithTheLine) {
  EXPECT_EQ(mistake(""), "prior.toml:1: no parameters; give [[parameter]] tables with name, low and high");
  EXPECT_EQ(mistake("[[parameter]]\nname = \"E\"\nlow = 2\nhigh = 1\n"),
            "prior.toml:4: parameter.0.high: 1 is not above low, 2");
  EXPECT_EQ(mistake("[[parameter]]\nname = \"E\"\nscale = \"log\"\nlow = 0\nhigh = 1\n"),
            "prior.toml:4: parameter.0.low: 0 on a log scale; must be above 0");
  EXPECT_EQ(mistake("[[parameter]]\nname = \"id\"\nlow = 0\nhigh = 1\n"),
            "prior.toml:2: parameter.0.name: 'id' is a column of every ensemble; use another");
  EXPECT_EQ(mistake("[[parameter]]\nname = \"a b\"\nlow = 0\nhigh = 1\n"),
            "prior.toml:2: parameter.0.name: 'a b' cannot name a column; use letters, digits and _");
  const std::string one = "[[parameter]]\nname = \"E\"\nlow = 0\nhigh = 1\n";
  EXPECT_EQ(mistake(one + one), "prior.toml:6: parameter.1.name: 'E' is a parameter already");
  EXPECT_NE(mistake("[[parameter]]\nname = \"E\"\nlow = nan\nhigh = 1\n").find("parameter.0.low"), std::string::npos);
  EXPECT_NE(mistake("[[parameter]]\nname = \"E\"\nlow = 0\nhigh = 1\nscael = \"log\"\n").find("did you mean 'scale'"),
            std::string::npos);
}

}  // namespace
}  // namespace soilweave::calibration
