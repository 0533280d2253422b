// Numbers, names and units as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/units.h"

namespace soilweave {
namespace {

TEST(Nearest, FindsSlipsOfTheFingerAndNothingElse) {
  const std::vector<std::string> known{"pressure", "friction", "void-ratio"};
  EXPECT_EQ(nearest("presure", known), "pressure");
  EXPECT_EQ(nearest("rpessure", known), "pressure");  // two letters swapped count as one edit
  EXPECT_EQ(nearest("frictoin", known), "friction");
  EXPECT_EQ(nearest("void", known), "void-ratio");
  EXPECT_EQ(nearest("temperature", known), "");
  EXPECT_EQ(suggestion("temperature", known), "; known: pressure, friction, void-ratio");
  EXPECT_EQ(suggestion("temperature", {}), "");
}

TEST(NumberText, ReadsBackAsTheSameNumber) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(1e9), "1e9");
  EXPECT_EQ(number_text(1.5e9), "1.5e9");
  EXPECT_EQ(number_text(-2e7), "-2e7");
  EXPECT_EQ(number_text(100000), "100000");
  for (const double value : {0.1, 1e-300, 12345678.9, 1e15, 1e22, -3e200, 1230000000.0, 1.0 / 3}) {
    const std::string text = number_text(value);
    double back = 0;
    std::from_chars(text.data(), text.data() + text.size(), back);
    EXPECT_EQ(back, value) << text;
  }
}

TEST(RangeText, SaysWhetherTheBoundsBelong) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(range_text({"x", "Pa", 0, 1, false}), "from 0 to 1 Pa");
  EXPECT_EQ(range_text({"x", "1", 0, 1, true}), "between 0 and 1");
  EXPECT_EQ(range_text({"x", "m", 0, infinity, true}), "above 0 m");
  EXPECT_EQ(range_text({"x", "m", 2, infinity, false}), "at least 2 m");
  EXPECT_EQ(range_text({"x", "1", -infinity, 2, true}), "below 2");
  EXPECT_EQ(range_text({"x", "1", -infinity, 2, false}), "at most 2");
  EXPECT_EQ(range_text({"x", "1"}), "");
}

TEST(Wrapped, BreaksAtBlanksAndKeepsLongWordsWhole) {
  EXPECT_EQ(wrapped("one two  three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("incomprehensibilities are", 5), (std::vector<std::string>{"incomprehensibilities", "are"}));
  EXPECT_EQ(lines_of("a\nb\n"), (std::vector<std::string>{"a", "b"}));
}

TEST(Quantity, ConvertsEveryUnitOfTheField) {
  EXPECT_EQ(quantity("0.1 MPa", "Pa"), 1e5);
  EXPECT_EQ(quantity("100kPa", "Pa"), 1e5);
  EXPECT_EQ(quantity("1 bar", "kPa"), 100);
  EXPECT_DOUBLE_EQ(quantity("2 N/mm2", "Pa"), 2e6);
  EXPECT_DOUBLE_EQ(quantity("2 N/mm^2", "Pa"), 2e6);
  EXPECT_DOUBLE_EQ(quantity("3 kN m/rad", "N m/rad"), 3000);
  EXPECT_DOUBLE_EQ(quantity("3 kN\u00b7m/rad", "N m/rad"), 3000);
  EXPECT_DOUBLE_EQ(quantity("10 %/s", "1/s"), 0.1);
  EXPECT_DOUBLE_EQ(quantity("1 s-1", "1/s"), 1);
  EXPECT_DOUBLE_EQ(quantity("180 deg", "rad"), 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(quantity("29\u00b0", "deg"), 29);
  EXPECT_DOUBLE_EQ(quantity("50 \u00b5m", "m"), 50e-6);
  EXPECT_DOUBLE_EQ(quantity("2 min", "s"), 120);
  EXPECT_DOUBLE_EQ(quantity("9.81 m/s2", "m/s2"), 9.81);
  EXPECT_DOUBLE_EQ(quantity("1 t/m3", "kg/m3"), 1000);
  EXPECT_EQ(quantity(" +2.5e-3", "Pa"), 2.5e-3);
}

TEST(Quantity, RefusesWhatIsNoNumberNoUnitOrAnotherDimension) {
  const auto message = [](std::string_view text, std::string_view unit) -> std::string {
    try {
      quantity(text, unit);
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("many", "Pa"), "'many' is not a number");
  EXPECT_EQ(message("", "Pa"), "'' is not a number");
  EXPECT_EQ(message("3 furlong", "m"), "'furlong' is not a known unit");
  EXPECT_EQ(message("3 m2", "m"), "'m2' does not measure what 'm' measures");
  EXPECT_EQ(message("3 N m", "N m/rad"), "'N m' does not measure what 'N m/rad' measures");
  EXPECT_EQ(message("1,5", "m"), "',5' is not a known unit");
}

TEST(Quantity, BareNumbersAreTakenAsTheyAre) { EXPECT_TRUE(std::isnan(quantity("nan", "Pa"))); }

}  // namespace
}  // namespace soilweave
