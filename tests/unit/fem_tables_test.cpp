// Tables of a two-scale run, from four points and two outputs written by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "fem/run/tables.h"
#include "support/messages.h"

namespace soilweave::fem {
namespace {

using soilweave::test::message_of;
using Values = std::vector<double>;

io::Column column(const std::string& name, Values values) { return {name, "1", "", std::move(values)}; }

/// Returns a square of 1 m with four points a quarter from its sides; in the second state all have moved by 10 m.
io::MultiscaleFile file() {
  io::MultiscaleFile f;
  f.series.columns = {column("step", {0, 5, 9}),
                      column("time", {0, 1, 2}),
                      column("pull_end", {0, 0.1, 0.2}),
                      column("force_x_bottom", {0, 4, 6}),
                      column("force_y_bottom", {10, 20, 30}),
                      column("length_bottom", {1, 2, 4}),
                      column("interface_normal", {0, 50, 100}),
                      column("interface_shear", {0, -10, 30}),
                      column("external_work", {0, 7, 8}),
                      column("energy_error", {0, 0.1, 0.2})};
  f.groups.push_back({"elements", "", {{column("element", {0, 1})}}});
  f.groups.push_back({"nodes",
                      "",
                      {{column("step", {0, 0, 0, 0}), column("node", {0, 1, 2, 3}), column("x", {0, 1, 1, 0}),
                        column("y", {0, 0, 1, 1})}}});
  f.groups.push_back(
      {"points",
       "",
       {{column("step", {0, 0, 0, 0, 9, 9, 9, 9}), column("point", {0, 1, 2, 3, 0, 1, 2, 3}),
         column("x", {0.25, 0.75, 0.25, 0.75, 10.25, 10.75, 10.25, 10.75}),
         column("y", {0.25, 0.25, 0.75, 0.75, 0.25, 0.25, 0.75, 0.75}), column("q", {1, 2, 3, 4, 11, 12, 13, 14})}}});
  return f;
}

TEST(Tables, LoadingIsTractionsFrictionAndBalanceOfTheSeries) {
  const io::Series t = loading(file());
  std::string names;
  for (const io::Column& c : t.columns) names += c.name + " ";
  EXPECT_EQ(names,
            "step time pull_end traction_x_bottom traction_y_bottom interface_friction external_work energy_error ");
  EXPECT_EQ(t.at("traction_x_bottom").values, (Values{0, 2, 1.5}));
  EXPECT_EQ(t.at("traction_y_bottom").values, (Values{10, 10, 7.5}));
  EXPECT_EQ(t.at("traction_y_bottom").unit, "Pa");
  const Values& friction = t.at("interface_friction").values;
  EXPECT_TRUE(std::isnan(friction[0]));  // no contact: no number, and not zero
  EXPECT_EQ(friction[1], 0.2);
  EXPECT_EQ(friction[2], -0.3);
  EXPECT_FALSE(std::signbit(t.at("traction_x_bottom").values[0]));
  EXPECT_EQ(t.at("energy_error").values, (Values{0, 0.1, 0.2}));
}

TEST(Tables, LoadingOfSoilWithoutAChainHasNoFriction) {
  io::MultiscaleFile f = file();
  std::erase_if(f.series.columns, [](const io::Column& c) { return c.name.starts_with("interface"); });
  EXPECT_EQ(loading(f).find("interface_friction"), nullptr);
}

TEST(Tables, ThoseThereAreGoByTheirNames) {
  EXPECT_EQ(table(file(), "series", "run.h5").rows(), 3U);
  EXPECT_EQ(table(file(), "loading", "run.h5").rows(), 3U);
  EXPECT_EQ(table(file(), "points", "run.h5").rows(), 8U);
  EXPECT_EQ(message_of<UsageError>([] { table(file(), "bars", "run.h5"); }),
            "--table bars: run.h5 has the tables loading, series, elements, nodes, points");
}

TEST(Tables, AStateIsAllRowsOfOneStep) {
  const io::Series points = table(file(), "points", "run.h5");
  EXPECT_EQ(of_state(points, "last", "points").at("q").values, (Values{11, 12, 13, 14}));
  EXPECT_EQ(of_state(points, "0", "points").at("q").values, (Values{1, 2, 3, 4}));
  EXPECT_EQ(of_state(points, "all", "points").rows(), 8U);
  EXPECT_EQ(of_state(loading(file()), "1", "loading").at("time").values, Values{1});
  EXPECT_EQ(message_of<UsageError>([&] { of_state(points, "2", "points"); }),
            "--state 2: the table points holds 2 states, 0 to 1");
  EXPECT_EQ(message_of<UsageError>([] { of_state(table(file(), "elements", ""), "last", "elements"); }),
            "--state last: the table elements has no states; leave --state out");
}

TEST(Tables, APlaceIsThePointNearestToItAtTheStart) {
  EXPECT_EQ(near(file(), "points", {0.9, 1}).at("q").values, (Values{4, 14}));
  EXPECT_EQ(near(file(), "points", {0.5, 0.5}).at("q").values, (Values{1, 11}));  // all are equally near: the first
  EXPECT_EQ(near(file(), "nodes", {0.9, 0.8}).at("node").values, Values{2});
  EXPECT_EQ(near(file(), "nodes", {0, 1 + 1e-9}).at("node").values, Values{3});  // rounding is not outside
  EXPECT_EQ(message_of<UsageError>([] {
              near(file(), "points", {0.5, 1.2});
            }),
            "--near 0.5,1.2: lies outside of the soil, which reaches from 0,0 to 1,1 m");
  EXPECT_EQ(message_of<UsageError>([] {
              near(file(), "elements", {0, 0});
            }),
            "--near belongs to --table points or nodes, not to elements");
}

}  // namespace
}  // namespace soilweave::fem
