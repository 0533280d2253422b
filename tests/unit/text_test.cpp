// Numbers, names and units as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/text/number_word.h"
#include "core/text/units.h"

namespace soilweave {
namespace {

TEST(TimeText, WritesNoExponent) {
  const std::vector<std::pair<double, std::string>> all{{0.5, "0.5 s"},     {45.0, "45 s"},    {99.4, "99 s"},
                                                        {110.0, "1.8 min"}, {5964, "99 min"},  {6600, "1.83 h"},
                                                        {171000, "47.5 h"}, {259200, "3 days"}};
  for (const auto& [seconds, text] : all) EXPECT_EQ(time_text(seconds), text);
}

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
  EXPECT_DOUBLE_EQ(quantity("2 N/mm\u00b2", "Pa"), 2e6);
  EXPECT_DOUBLE_EQ(quantity("2 kN/m\u00b2", "Pa"), 2000);
  EXPECT_DOUBLE_EQ(quantity("2 kN m\u207b\u00b2", "Pa"), 2000);
  EXPECT_DOUBLE_EQ(quantity("2650 kg/m\u00b3", "kg/m3"), 2650);
  EXPECT_DOUBLE_EQ(quantity("2.65 g/cm3", "kg/m3"), 2650);
  EXPECT_DOUBLE_EQ(quantity("5 \u2030", "1"), 0.005);
  EXPECT_DOUBLE_EQ(quantity("50 \u03bcm", "m"), 50e-6);
  EXPECT_EQ(quantity("100\u00a0kPa", "Pa"), 1e5);
  EXPECT_EQ(quantity(" 100\u202fkPa ", "Pa"), 1e5);
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
  EXPECT_EQ(message("3 furlong", "m").find("'furlong' is not a known unit; known: m, mm, um"), 0U);
  EXPECT_EQ(message("100 KPa", "Pa"), "'KPa' is not a known unit; did you mean 'kPa'?");
  EXPECT_EQ(message("1 mpa", "Pa"), "'mpa' is not a known unit; did you mean 'MPa'?");
  EXPECT_EQ(message("1 KN/m2", "Pa"), "'KN' is not a known unit; did you mean 'kN'?");
  EXPECT_EQ(message("5 microns", "m"), "'microns' is not a known unit; did you mean 'um'?");
  EXPECT_EQ(message("1 MM2", "m2"), "'MM2' is not a known unit; did you mean 'mm'?");
  EXPECT_EQ(message("3 m2", "m"), "'m2' does not measure what 'm' measures");
  EXPECT_EQ(message("3 N m", "N m/rad"), "'N m' does not measure what 'N m/rad' measures");
  EXPECT_EQ(message("1,5", "m"), "'1,5' is not a number: write 1.5, with a decimal point");
  EXPECT_EQ(message("0,1 MPa", "Pa"), "'0,1 MPa' is not a number: write 0.1, with a decimal point");
  EXPECT_EQ(message("100,000 Pa", "Pa"),
            "'100,000 Pa' is not a number: write 100000 if the comma separates thousands, 100.000 if it is a decimal "
            "comma");
  EXPECT_EQ(message("0,125 m", "m"), "'0,125 m' is not a number: write 0.125, with a decimal point");
  EXPECT_EQ(message("1000,125 m", "m"), "'1000,125 m' is not a number: write 1000.125, with a decimal point");
  EXPECT_EQ(message(",5 MPa", "Pa"), "',5 MPa' is not a number: write .5, with a decimal point");
  EXPECT_EQ(message("1.000,5 m", "m"),
            "'1.000,5 m' is not a number: write its digits without commas, with one decimal point");
  EXPECT_EQ(message("12 000 000.5 Pa", "Pa"), "'12 000 000.5 Pa' is not a number: write 12000000.5, without blanks");
  EXPECT_EQ(message("- 5 Pa", "Pa"), "'- 5 Pa' is not a number: write -5, without blanks");
  // A unit follows the number, and a second number is none of its digits.
  EXPECT_EQ(quantity("0.1 1 /s", "1/s"), 0.1);
  EXPECT_EQ(message("0.1 2 /s", "1/s").find("write"), std::string::npos);
  EXPECT_EQ(message("1 000 Pa", "Pa"), "'1 000 Pa' is not a number: write 1000, without blanks");
  EXPECT_EQ(message("1\u202f000\u00a0Pa", "Pa"), "'1\u202f000\u00a0Pa' is not a number: write 1000, without blanks");
  EXPECT_EQ(message("1.0D+03 Pa", "Pa"), "'1.0D+03 Pa' is not a number: write 1.0e+03");
  EXPECT_EQ(message("\u22125 m", "m"), "'\u22125 m' is not a number: write -5, with the minus sign of the keyboard");
  EXPECT_EQ(message("1e999", "m").find("'1e999' is not a number: it is beyond the range"), 0U);
}

TEST(NumberWord, IsReadWholeOrNotAtAll) {
  EXPECT_EQ(number_of("+1.5e3"), 1500);
  for (const char* word : {"", "+", "++1", "+-1", "1,5", "1.0D+00", "1e999", "0x10", "1 ", "1.0O"})
    EXPECT_FALSE(number_of(word)) << word;
  EXPECT_EQ(no_number("1.0D+00"), "\"1.0D+00\" is no number: write 1.0e+00");
  EXPECT_EQ(no_number("10,5", "finite number"), "\"10,5\" is no finite number: write 10.5, with a decimal point");
  EXPECT_EQ(no_number("50 %"), "\"50 %\" is no number: write the number, and [%] behind the name of its column");
  EXPECT_EQ(no_number("x"), "\"x\" is no number");
  EXPECT_EQ(trimmed("\u00a0 \t1\u202f\r\n"), "1");
}

TEST(Quantity, BareNumbersAreTakenAsTheyAre) { EXPECT_TRUE(std::isnan(quantity("nan", "Pa"))); }

}  // namespace
}  // namespace soilweave
