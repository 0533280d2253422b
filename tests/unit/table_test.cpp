// Tables come back as they were, and errors say line and column.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "support/same_state.h"

namespace soilweave::io {
namespace {

using test::expect_error;

TEST(Table, is_written_with_units_and_shortest_numbers) {
  const Series series = {{{"time", "s", "", {0, 0.1}}, {"p", "Pa", "", {1e5, 1.0 / 3}}, {"n", "", "", {2, -0.0}}}};
  EXPECT_EQ(to_tsv(series), "time [s]\tp [Pa]\tn\n0\t1e+05\t2\n0.1\t0.3333333333333333\t-0\n");
  EXPECT_EQ(to_tsv({}), "\n");
}

TEST(Table, comes_back_exactly) {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const Series series = {{{"a", "kg m-3", "", {least, most, -0.0}}, {"b", "1", "", {0.1 + 0.2, INFINITY, -1e-300}}}};
  test::expect_same(series, from_tsv(to_tsv(series), "table"));
  EXPECT_TRUE(std::isnan(from_tsv("a\nnan\n", "table").at("a").values[0]));
}

TEST(Table, takes_comments_blanks_and_other_line_ends) {
  const Series series = from_tsv("# from a spreadsheet\r\n a [m] \tb\r\n\r\n 1\t+2 \r\n# end\n3\t4", "table");
  ASSERT_EQ(series.columns.size(), 2U);
  EXPECT_EQ(series.columns[0].name, "a");
  EXPECT_EQ(series.columns[0].unit, "m");
  EXPECT_EQ(series.columns[0].values, (std::vector<double>{1, 3}));
  EXPECT_EQ(series.columns[1].values, (std::vector<double>{2, 4}));
}

TEST(Table, tells_line_and_column) {
  expect_error<DataError>([] { from_tsv("a\tb\n1\t2\n3\tx\n", "t.tsv"); },
                          "t.tsv: line 3, column 2: \"x\" is no number");
  expect_error<DataError>([] { from_tsv("# c\na\tb\n1\n", "t.tsv"); }, "t.tsv: line 3, column 2: 1 values where the");
  expect_error<DataError>([] { from_tsv("a\n1\t2\n", "t.tsv"); }, "t.tsv: line 2, column 2: 2 values where the header");
  expect_error<DataError>([] { from_tsv("a\n1 2\n", "t.tsv"); }, "t.tsv: line 2, column 1: \"1 2\" is no number");
  expect_error<DataError>([] { from_tsv("1\t2\n", "t.tsv"); }, "t.tsv: line 1, column 1: a number where the header");
  expect_error<DataError>([] { from_tsv("a\ta\n", "t.tsv"); }, "t.tsv: line 1, column 2: a second column named a");
  expect_error<DataError>([] { from_tsv("a\t\n", "t.tsv"); }, "t.tsv: line 1, column 2: a column without a name");
  expect_error<DataError>([] { from_tsv("# nothing\n", "t.tsv"); }, "t.tsv: no header line");
  expect_error<DataError>([] { from_tsv("a\n1e999\n", "t.tsv"); }, "line 2, column 1: \"1e999\" is no number");
}

TEST(Table, names_the_nearest_column) {
  const Series series = {{{"mean_stress", "Pa", "", {}}, {"deviatoric_stress", "Pa", "", {}}}};
  EXPECT_EQ(series.at("mean_stress").unit, "Pa");
  EXPECT_EQ(series.find("void_ratio"), nullptr);
  expect_error<DataError>([&] { series.at("mean_strss"); }, "no column mean_strss; the nearest is mean_stress");
  expect_error<DataError>([] { Series().at("p"); }, "no column p: the table is empty");
}

TEST(Table, columns_of_other_lengths_are_no_table) {
  const Series series = {{{"a", "", "", {1, 2}}, {"b", "", "", {1}}}};
  expect_error<DataError>([&] { to_tsv(series); }, "column b has another length");
}

}  // namespace
}  // namespace soilweave::io
