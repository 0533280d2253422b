// Tables come back unchanged, and errors name line and column.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "support/same_state.h"

namespace soilweave::io {
namespace {

using test::expect_error;

TEST(Table, IsWrittenWithUnitsAndShortestNumbers) {
  const Series series = {{{"time", "s", "", {0, 0.1}}, {"p", "Pa", "", {1e5, 1.0 / 3}}, {"n", "", "", {2, -0.0}}}};
  EXPECT_EQ(to_tsv(series), "time [s]\tp [Pa]\tn\n0\t1e+05\t2\n0.1\t0.3333333333333333\t-0\n");
  EXPECT_EQ(to_tsv({}), "\n");
}

TEST(Table, ComesBackExactly) {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const Series series = {{{"a", "kg m-3", "", {least, most, -0.0}}, {"b", "1", "", {0.1 + 0.2, INFINITY, -1e-300}}}};
  test::expect_same(series, from_tsv(to_tsv(series), "table"));
  EXPECT_TRUE(std::isnan(from_tsv("a\nnan\n", "table").at("a").values[0]));
}

TEST(Table, TakesCommentsBlanksAndOtherLineEnds) {
  const Series series = from_tsv("# from a spreadsheet\r\n a [m] \tb\r\n\r\n 1\t+2 \r\n# end\n3\t4", "table");
  ASSERT_EQ(series.columns.size(), 2U);
  EXPECT_EQ(series.columns[0].name, "a");
  EXPECT_EQ(series.columns[0].unit, "m");
  EXPECT_EQ(series.columns[0].values, (std::vector<double>{1, 3}));
  EXPECT_EQ(series.columns[1].values, (std::vector<double>{2, 4}));
}

TEST(Table, TellsLineAndColumn) {
  expect_error<DataError>([] { from_tsv("a\tb\n1\t2\n3\tx\n", "t.tsv"); },
                          "t.tsv: line 3, column 2: \"x\" is no number");
  expect_error<DataError>([] { from_tsv("# c\na\tb\n1\n", "t.tsv"); }, "t.tsv: line 3, column 2: 1 values where the");
  expect_error<DataError>([] { from_tsv("a\n1\t2\n", "t.tsv"); }, "t.tsv: line 2, column 2: 2 values where the header");
  expect_error<DataError>([] { from_tsv("a\tb\n1\t\n", "t.tsv"); }, "t.tsv: line 2, column 2: no value of b; fill");
  expect_error<DataError>([] { from_tsv("a\n1 2\n", "t.tsv"); }, "t.tsv: line 2, column 1: \"1 2\" is no number");
  expect_error<DataError>([] { from_tsv("1\t2\n", "t.tsv"); }, "t.tsv: line 1, column 1: a number where the header");
  expect_error<DataError>([] { from_tsv("a\ta\n", "t.tsv"); }, "t.tsv: line 1, column 2: a second column named a");
  expect_error<DataError>([] { from_tsv("a\t\n", "t.tsv"); }, "t.tsv: line 1, column 2: a column without a name");
  expect_error<DataError>([] { from_tsv("# nothing\n", "t.tsv"); }, "t.tsv: no header line");
  expect_error<DataError>([] { from_tsv("a\n1e999\n", "t.tsv"); }, "line 2, column 1: \"1e999\" is no number");
}

TEST(Table, TakesTheSeparatorOfItsHeader) {
  for (const std::string separator : {"\t", ",", ";", " ; ", ", "}) {
    const Series series =
        from_tsv("\"diameter [mm]\"" + separator + "finer\u00a0[1]\n\"1.5\"" + separator + "\u202f2\u00a0\n", "t");
    ASSERT_EQ(series.columns.size(), 2U) << separator;
    EXPECT_EQ(series.columns[0].name, "diameter");
    EXPECT_EQ(series.columns[0].unit, "mm");
    EXPECT_EQ(series.columns[1].name, "finer");
    EXPECT_EQ(series.columns[1].unit, "1");
    EXPECT_EQ(series.columns[0].values, std::vector<double>{1.5});
    EXPECT_EQ(series.columns[1].values, std::vector<double>{2});
  }
  EXPECT_EQ(from_tsv("\"a \"\"b\"\", c\",d\n1,2\n", "t").columns[0].name, "a \"b\", c");
  const Series round = from_tsv("p (kN/m\u00b2),finer (%),q (first),r ()\n1,2,3,4\n", "t");
  EXPECT_EQ(round.columns[0].unit, "kN/m\u00b2");
  EXPECT_EQ(round.columns[1].unit, "%");
  EXPECT_EQ(round.columns[2].name, "q (first)");
  EXPECT_EQ(round.columns[3].name, "r ()");
}

TEST(Table, TellsSeparatorsAndDecimalCommas) {
  const auto refuses = [](const std::string& text, const std::string& words) {
    expect_error<DataError>([&] { from_tsv(text, "t"); }, words);
  };
  refuses("a\tb\n1,5\t2\n", "t: line 2, column 1: \"1,5\" is no number: write 1.5, with a decimal point");
  refuses("a;b\n1,5;2\n", "t: line 2, column 1: \"1,5\" is no number: write 1.5");
  refuses("a\n1,5\n", "t: line 2, column 1: \"1,5\" is no number: write 1.5");
  refuses("a,b\n1,5,2,5\n", "line 2, column 3: 4 values where the header names 2 columns, separated by commas; with");
  refuses("a\tb\n1;2\n", "1 values where the header names 2 columns, separated by tabs; this line has semicolons");
  refuses("a,b\n1\t2\n", "separated by commas; this line has tabs: use one separator throughout");
  refuses("a [m] b [m]\n1 2\n", "t: line 1, column 1: names separated by blanks; separate columns by tabs, commas or");
  refuses("a b\n1 2\n", "t: line 2, column 1: \"1 2\" is no number");
  refuses("a b\n1 x\n", "\"1 x\" is no number; separate columns by tabs, commas or semicolons");
  refuses("0,0,60\n0.1,0.16,59.24\n", "t: line 1, column 1: a number where the header belongs");
  refuses("0,5\n", "t: line 1, column 1: a number where the header belongs");
  refuses("a\tb\n1.0D+00\t2\n", "\"1.0D+00\" is no number: write 1.0e+00");
}

TEST(Table, ConvertsColumnsByTheirUnits) {
  const Series table = from_tsv("a [%]\tb [um]\tc [N/mm\u00b2]\td\te [KPa]\tf [\u2030]\n50\t200\t2\t0.5\t1\t5\n", "t");
  EXPECT_EQ(in_unit(table, "a", "1", "t"), std::vector<double>{0.5});
  EXPECT_DOUBLE_EQ(in_unit(table, "b", "m", "t")[0], 200e-6);
  EXPECT_DOUBLE_EQ(in_unit(table, "c", "Pa", "t")[0], 2e6);
  EXPECT_EQ(in_unit(table, "d", "1", "t"), std::vector<double>{0.5});
  EXPECT_DOUBLE_EQ(in_unit(table, "f", "1", "t")[0], 0.005);
  const auto refuses = [&](const char* name, const char* unit, const std::string& words) {
    expect_error<DataError>([&] { in_unit(table, name, unit, "t"); }, words);
  };
  refuses("d", "m", "t: column d: has no unit: write it in the header, such as d [m]");
  refuses("e", "Pa", "t: column e: 'KPa' is not a known unit; did you mean 'kPa'?");
  refuses("b", "Pa", "t: column b: 'um' does not measure what 'Pa' measures");
  refuses("x", "Pa", "t: no column x among a, b, c, d, e, f");
}

TEST(Table, OfAHundredThousandColumnsIsReadAndNamedInShort) {
  std::string head = "c0", row = "0";
  for (int k = 1; k < 100'000; ++k) head += "\tc" + std::to_string(k), row += "\t0";
  const Series table = from_tsv(head + "\n" + row + "\n", "t");
  EXPECT_LT(column_names(table).size(), 200U);
}

TEST(Table, NamesTheNearestColumn) {
  const Series series = {{{"mean_stress", "Pa", "", {}}, {"deviatoric_stress", "Pa", "", {}}}};
  EXPECT_EQ(series.at("mean_stress").unit, "Pa");
  EXPECT_EQ(series.find("void_ratio"), nullptr);
  expect_error<DataError>([&] { series.at("mean_strss"); },
                          "no column mean_strss among mean_stress, deviatoric_stress; did you mean mean_stress?");
  expect_error<DataError>([] { Series().at("p"); }, "no column p: the table is empty");
}

TEST(Table, ColumnsOfOtherLengthsAreNoTable) {
  const Series series = {{{"a", "", "", {1, 2}}, {"b", "", "", {1}}}};
  expect_error<DataError>([&] { to_tsv(series); }, "column b has another length");
}

}  // namespace
}  // namespace soilweave::io
