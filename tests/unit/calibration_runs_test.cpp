// Observations and runs: stations, columns, units, interpolation, and the fate of missing and unfit runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "calibration/output/report.h"
#include "calibration/sampling.h"
#include "core/error.h"
#include "files/exchange/table.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::calibration {
namespace {

const std::string lab =
    "strain_axial [%]\tratio [1]\tstrain_radial [%]\n"
    "0.5\t2\t-0.1\n1\t3\t-0.3\n2\t4\t-0.9\n";

Observations observed(const Choice& choice = {}) {
  return observations(io::from_tsv(lab, "lab.tsv"), choice, "lab.tsv");
}

std::string mistake(const std::string& text, const Choice& choice = {}) {
  try {
    observations(io::from_tsv(text, "lab.tsv"), choice, "lab.tsv");
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(Observations, AllColumnsOrThoseAskedForUpToAStation) {
  const Observations all = observed();
  EXPECT_EQ(all.station.name, "strain_axial");
  ASSERT_EQ(all.observables.size(), 2u);
  EXPECT_EQ(all.values(2, 1), -0.9);
  const Observations some = observed({"strain_axial", {"strain_radial=strain_xx,strain_yy"}, "1", {}});
  EXPECT_EQ(some.stations(), 2u);
  EXPECT_EQ(observed({"strain_axial", {"strain_radial=strain_xx,strain_yy"}, "1 %", {}}).stations(), 2u);
  EXPECT_EQ(some.observables[0].columns, (std::vector<std::string>{"strain_xx", "strain_yy"}));
}

TEST(Observations, WhatCannotBeUsedIsSaid) {
  EXPECT_EQ(mistake("x\ty\n1\tnan\n"),
            "lab.tsv: row 1: y is not finite; take the row out, or leave the column out by --observe");
  EXPECT_EQ(mistake("x\ty\n1\t1\n1\t2\n"), "lab.tsv: row 2: x 1 is not above 1; sort the rows, keep one of equal ones");
  EXPECT_EQ(mistake("x\ty\nnan\t1\n"), "lab.tsv: row 1: x is not finite");
  EXPECT_EQ(mistake("x\n1\n"), "lab.tsv: nothing observed beside x");
  EXPECT_EQ(mistake("x\ty\n"), "lab.tsv: no observations");
  EXPECT_EQ(mistake("x\ty\n1\t1\n", {"", {}, "0.5", {}}),
            "lab.tsv: no observations up to --until 0.5: the first is at 1");
  EXPECT_EQ(mistake("x [%]\ty\n5\t1\n", {"", {}, "4 %", {}}),
            "lab.tsv: no observations up to --until 4 %: the first is at 5 %");
  EXPECT_EQ(mistake("x [%]\ty\n5\t1\n7\t1\n", {"", {}, "6 %", {}}), "");
  EXPECT_NE(mistake("x [%]\ty\n5\t1\n", {"", {}, "4 mm", {}}).find("lab.tsv: --until: "), std::string::npos);
  EXPECT_EQ(mistake("x\ty\n1\t1\n", {"", {"z"}, {}, {}}), "lab.tsv: no column z among x, y");
  EXPECT_EQ(mistake("x\ty\n1\t1\n", {"", {"y", "y=z"}, {}, {}}),
            "lab.tsv: y is to be observed twice, and would count twice: name it once");
  EXPECT_EQ(mistake("x\ty\n1\t1\n", {"", {"y", "x"}, {}, {}}),
            "lab.tsv: x is the station, at which every run agrees with it: leave it out of --observe, or name another "
            "--station");
}

/// A folder with runs 0.tsv, 1.tsv, ..., and their fates against the laboratory.
struct Runs {
  io::test::Folder folder;
  std::vector<std::int64_t> ids;
  std::vector<io::Source> sources;

  void add(const std::string& text) {
    io::test::put_bytes(folder / (std::to_string(ids.size()) + ".tsv"), text);
    ids.push_back(static_cast<std::int64_t>(ids.size()));
  }
  Simulated read(const Choice& choice) {
    return simulated((folder / "{id}.tsv").string(), ids, observations(io::from_tsv(lab, "lab.tsv"), choice, "lab.tsv"),
                     choice, sources);
  }
};

const Choice compared{"strain_axial", {"ratio", "strain_radial=strain_xx,strain_yy"}, {}, {{"stage", 1}}};
const std::string header = "stage\tstrain_axial [1]\tratio\tstrain_xx [1]\tstrain_yy [1]\n";

TEST(Runs, AreInterpolatedAtTheStationsInTheUnitsOfTheObservations) {
  Runs runs;
  runs.add(header + "0\t0.5\t9\t9\t9\n1\t0\t1\t0\t0\n1\t0.01\t2\t-0.002\t-0.004\n1\t0.03\t6\t-0.004\t-0.004\n");
  const Simulated s = runs.read(compared);
  ASSERT_EQ(s.used(), 1u);
  EXPECT_DOUBLE_EQ(s.values[0](0, 0), 1.5);
  EXPECT_DOUBLE_EQ(s.values[0](1, 0), 2);
  EXPECT_DOUBLE_EQ(s.values[0](2, 0), 4);
  EXPECT_NEAR(s.values[0](0, 1), -0.15, 1e-12);
  EXPECT_NEAR(s.values[0](2, 1), -0.35, 1e-12);
  ASSERT_EQ(runs.sources.size(), 1u);
  EXPECT_EQ(runs.sources[0].role, "runs");
}

TEST(Runs, DeviateFromTheObservationsByRootMeanSquares) {
  Runs runs;
  runs.add(header + "1\t0\t2\t0\t0\n1\t0.03\t2\t0\t0\n");  // ratio 2 everywhere, radial strain 0
  runs.add(header + "1\t0\t2\t0\t0\n1\t0.01\t2\t0\t0\n");  // too short
  const Simulated s = runs.read(compared);
  const Prior prior{{{"a", "1", "", 0, 1, Scale::linear}}};
  const Assimilation a = assimilate(members_at(prior, halton(2, {2}, 1)), observed(compared), s,
                                    {ErrorModel::Kind::uniform, {1}}, std::nullopt, {});
  const io::Series table = table_of(a, groups_of(a), "runs");
  EXPECT_DOUBLE_EQ(table.at("ratio_misfit").values[0], std::sqrt((0 + 1 + 4) / 3.0));
  EXPECT_DOUBLE_EQ(table.at("ratio_misfit_relative").values[0], std::sqrt((0 + 1 / 9.0 + 1 / 4.0) / 3));
  EXPECT_DOUBLE_EQ(table.at("strain_radial_misfit").values[0], std::sqrt((0.01 + 0.09 + 0.81) / 3));
  EXPECT_EQ(table.at("strain_radial_misfit").unit, "%");
  EXPECT_TRUE(std::isnan(table.at("ratio_misfit").values[1]));
  EXPECT_TRUE(std::isnan(table.at("ratio_misfit_relative").values[1]));
  const io::Series curves = table_of(a, groups_of(a), "curves");
  EXPECT_EQ(curves.at("id").values, (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(curves.at("strain_axial").values, (std::vector<double>{0.5, 1, 2}));
  EXPECT_EQ(curves.at("ratio").values, (std::vector<double>{2, 2, 2}));
  EXPECT_EQ(curves.at("ratio_observed").values, (std::vector<double>{2, 3, 4}));
}

TEST(Runs, HaveNoRelativeDeviationFromAnObservationOfZero) {
  Runs runs;
  runs.add(header + "1\t0\t2\t0\t0\n1\t0.03\t2\t0\t0\n");
  Observations zero = observed(compared);
  zero.values(1, 0) = 0;
  const Prior prior{{{"a", "1", "", 0, 1, Scale::linear}}};
  const Assimilation a = assimilate(members_at(prior, halton(1, {2}, 1)), zero, runs.read(compared),
                                    {ErrorModel::Kind::uniform, {1}}, std::nullopt, {});
  EXPECT_TRUE(std::isnan(table_of(a, groups_of(a), "runs").at("ratio_misfit_relative").values[0]));
}

TEST(Runs, AreComparedByTheirGreatestValuesWhereNoStationIsKnown) {
  Runs runs;
  runs.add("stage\tratio\n0\t9\n1\t2\n1\t5\n1\t3\n");
  runs.add("stage\tratio\n1\t2\n1\tnan\n");
  const Choice choice{"", {"peak=ratio"}, {}, {{"stage", 1}}, true};
  const Observations peak = observations(io::from_tsv("pressure [kPa]\tpeak [1]\n200\t4.5\n", "peak.tsv"), choice, "");
  const Simulated s = simulated((runs.folder / "{id}.tsv").string(), runs.ids, peak, choice, runs.sources);
  EXPECT_EQ(s.values[0](0, 0), 5);
  EXPECT_EQ(s.fate[1], Fate::not_finite);
  EXPECT_EQ(s.why[1], "peak of row 2 is not finite");
  const std::string two = "pressure\tpeak\n200\t4.5\n400\t4.2\n";
  EXPECT_NE(mistake(two, choice).find("2 rows where --greatest compares one value of a run"), std::string::npos);
}

TEST(Runs, ThatAreMissingOrUnfitHaveNoValuesAndAReason) {
  Runs runs;
  const std::string good = header + "1\t0\t1\t0\t0\n1\t0.03\t6\t0\t0\n";
  runs.add(good);
  runs.add(header + "1\t0\t1\t0\t0\n1\t0.015\t6\t0\t0\n");
  runs.add(header + "1\t0\t1\t0\t0\n1\t0.03\tnan\t0\t0\n");
  runs.add(header + "1\t0\t1\t0\t0\n1\t0.02\t2\t0\t0\n1\t0.01\t6\t0\t0\n");
  runs.add("1\t2\n");
  runs.add(header + "0\t0\t1\t0\t0\n");
  runs.add(header + "1\t0.01\t1\t0\t0\n1\t0.03\t6\t0\t0\n");
  runs.ids.push_back(7);
  const Simulated s = runs.read(compared);
  using enum Fate;
  EXPECT_EQ(s.fate, (std::vector{used, too_short, not_finite, unordered, unreadable, too_short, too_short, missing}));
  EXPECT_EQ(s.why[1], "ends at strain_axial 1.5, the observations at 2");
  EXPECT_EQ(s.why[2], "ratio at strain_axial 0.5 is not finite");
  EXPECT_EQ(s.why[3], "strain_axial does not increase from row 2 to 3");
  EXPECT_NE(s.why[4].find("4.tsv"), std::string::npos);
  EXPECT_EQ(s.why[5], "has no rows");
  EXPECT_EQ(s.why[6], "begins at strain_axial 1, the observations at 0.5");
  EXPECT_NE(s.why[7].find("7.tsv: no such file"), std::string::npos);
  const Prior prior{{{"a", "1", "", 0, 1, Scale::linear}}};
  const Assimilation a = assimilate(members_at(prior, halton(8, {2}, 1)), observed(compared), s,
                                    {ErrorModel::Kind::uniform, {1}}, std::nullopt, {});
  EXPECT_EQ(a.ensemble.weight[0], 1);
  EXPECT_EQ(a.ensemble.weight.tail(7).norm(), 0);
  EXPECT_NE(
      describe(a).find("8 parameter sets, 1 runs used, 1 missing, 1 unreadable, 1 out of order, 1 diverged, 3 too "
                       "short; those have no weight:\n  1 too short: ends at"),
      std::string::npos)
      << describe(a);
  const std::string unused = doubts(a, false).front().sentence;
  EXPECT_EQ(
      unused.find("7 of 8 runs are not used and have no weight: member 1, too short (ends at strain_axial 1.5, the "
                  "observations at 2); member 2, diverged (ratio at strain_axial 0.5 is not finite); member 3, out "
                  "of order (strain_axial does not increase from row 2 to 3); 4 more (--table runs); make such runs"),
      0u)
      << unused;
  for (const auto& group : groups_of(a))
    for (const io::Column& column : group.table.columns)
      for (const double value : column.values)
        EXPECT_TRUE(std::isfinite(value) || column.name.find("misfit") != std::string::npos ||
                    column.name == "correlation")
            << group.name << " " << column.name;
}

std::string said(const Simulated& runs) {
  std::string all;
  for (const Doubt& doubt : runs.doubts) all += doubt.key + ": " + doubt.sentence + "\n";
  return all;
}

TEST(Runs, WhoseRowsLieFarApartAmongTheStationsAreDoubted) {
  Runs runs;
  runs.add(header + "1\t0\t0\t0\t0\n1\t0.005\t1\t0\t0\n1\t0.01\t2\t0\t0\n1\t0.02\t3\t0\t0\n");
  EXPECT_EQ(said(runs.read(compared)), "");
  runs.add(header + "1\t0\t0\t0\t0\n1\t0.03\t3\t0\t0\n");
  EXPECT_EQ(said(runs.read(compared)),
            "coarse: the run of member 1 has no row between strain_axial 0 and 3, and counts as a straight line there, "
            "where strain_axial 0.5 is observed; give runs with rows near the stations of the observations, or check "
            "the unit of strain_axial in both tables\n");
}

TEST(Runs, ThatNameOtherParametersThanTheirSetsAreDoubted) {
  Runs runs;
  const std::string head = "stage\tE [Pa]\tmu\tstrain_axial [1]\tratio\tstrain_xx [1]\tstrain_yy [1]\n";
  for (const char* set : {"1e7\t0.5", "2e7\t0.5"}) {
    std::string text = head;
    for (const double at : {0.0, 0.005, 0.01, 0.02})
      text += fmt::format("1\t{}\t{}\t{}\t0\t0\n", set, at, runs.ids.size());
    runs.add(text);
  }
  const auto read = [&](double first, double second) {
    const io::Series sets{{{"E", "Pa", "", {first, second}}, {"mu", "1", "", {0.5, 0.5}}}};
    const Observations lab_curve = observed(compared);
    return said(simulated((runs.folder / "{id}.tsv").string(), runs.ids, lab_curve, compared, runs.sources, sets));
  };
  EXPECT_EQ(read(1.001e7, 2e7), "");
  EXPECT_EQ(
      read(1e7, 3e7),
      "other_sets: 1 run names other parameters than the sets of their ids have, as member 1, whose E is 2e+07 in "
      "its run and 3e+07 in its set; give the ensemble that these runs were made with\n");
}

TEST(Runs, ThatAreEqualAlthoughTheirSetsDifferAreDoubted) {
  Runs runs;
  for (const int ratio : {5, 5, 6, 5, 5, 5}) {
    std::string text = header;
    for (const double at : {0.0, 0.005, 0.01, 0.02}) text += fmt::format("1\t{}\t{}\t0\t0\n", at, ratio);
    runs.add(text);
  }
  const auto read = [&](const std::vector<double>& E) {
    const io::Series sets{{{"E", "Pa", "", E}}};
    const Observations lab_curve = observed(compared);
    return said(simulated((runs.folder / "{id}.tsv").string(), runs.ids, lab_curve, compared, runs.sources, sets));
  };
  EXPECT_EQ(read({1, 1, 2, 1, 1, 1}), "");
  const std::string begins = "equal_runs: members of other parameters have equal runs, and each is weighted: ";
  const std::string remedy =
      "; give each its own run, unless its parameters change nothing that the runs are compared by\n";
  EXPECT_EQ(read({1, 2, 3, 1, 1, 1}), begins + "1 as 0" + remedy);
  EXPECT_EQ(read({1, 2, 3, 4, 5, 6}), begins + "1 as 0, 3 as 0, 4 as 0, and 1 more" + remedy);
}

TEST(Runs, AColumnThatIsNotThereIsAnErrorOfTheWhole) {
  Runs runs;
  runs.add("stage\tstrain_axial [1]\trate\n1\t0\t1\n");
  EXPECT_THROW(runs.read(compared), DataError);
  runs.add("stage\tstrain_axial [kPa]\tratio\tstrain_xx\tstrain_yy\n1\t0\t1\t0\t0\n");
  EXPECT_THROW(runs.read(compared), DataError);
}

TEST(Runs, OneTableHoldsTheRunsOfAllMembers) {
  const io::test::Folder folder;
  io::test::put_bytes(folder / "runs.tsv",
                      "id\tstrain_axial [%]\tratio\tstrain_radial [%]\n"
                      "4\t0\t1\t0\n4\t2\t5\t-1\n2\t0\t1\t0\n2\t1\t5\t-1\n");
  std::vector<io::Source> sources;
  const Simulated s = simulated((folder / "runs.tsv").string(), {4, 2, 3}, observed(), {}, sources);
  EXPECT_EQ(s.fate, (std::vector{Fate::used, Fate::too_short, Fate::missing}));
  EXPECT_DOUBLE_EQ(s.values[0](1, 0), 3);
  EXPECT_THROW(simulated("{nonsense}", {1}, observed(), {}, sources), UsageError);
}

TEST(Runs, TheSeriesOfRunFilesAreReadWithoutTheirStates) {
  const io::test::Folder folder;
  const io::RunFile run = io::test::example_run();
  io::write_run(folder / "0.h5", run, {});
  const io::SeriesFile read = io::read_run_series(folder / "0.h5");
  EXPECT_EQ(read.series.columns.size(), run.series.columns.size());
  EXPECT_EQ(read.series.rows(), run.series.rows());
  io::write_fields(folder / "1.h5", {{{"series", "", run.series}}, {}}, {});
  EXPECT_EQ(io::read_run_series(folder / "1.h5").series.rows(), run.series.rows());
  io::write_fields(folder / "2.h5", {{{"cell", "", run.series}}, {}}, {});
  EXPECT_THROW(io::read_run_series(folder / "2.h5"), DataError);
}

TEST(Ensembles, GoThroughFilesAndTablesUnchanged) {
  const io::test::Folder folder;
  const Prior prior{{{"E", "Pa", "modulus", 1e7, 1e11, Scale::log}, {"mu", "deg", "friction", 0, 60, Scale::linear}}};
  Ensemble e = members_at(prior, halton(5, {2, 3}, 1), 10);
  e.log_importance[2] = -0.25;
  e.weight = Vector::Constant(5, 0.2);
  io::write_ensemble(folder / "e.h5", ensemble_file(e), {});
  io::test::put_bytes(folder / "e.tsv", io::to_tsv(members_table(e)));
  io::test::put_bytes(folder / "prior.toml", prior_text(prior));
  std::vector<io::Source> sources;
  for (const Ensemble& read :
       {read_ensemble(folder / "e.h5", {}, sources), read_ensemble(folder / "e.tsv", folder / "prior.toml", sources)}) {
    EXPECT_EQ(read.id, e.id);
    EXPECT_EQ(read.values, e.values);
    EXPECT_EQ(read.log_importance, e.log_importance);
    EXPECT_EQ(read.weight, e.weight);
    EXPECT_EQ(read.prior.ranges[0].scale, Scale::log);
    EXPECT_LT((read.coordinates() - halton(5, {2, 3}, 1)).norm(), 1e-12);
  }
  EXPECT_EQ(read_ensemble(folder / "e.tsv", {}, sources).prior.ranges[1].low, e.values.col(1).minCoeff());
  EXPECT_EQ(read_ensemble(folder / "e.h5", {}, sources).rounds.at(0).sets, 5u);
  EXPECT_TRUE(read_ensemble(folder / "e.tsv", folder / "prior.toml", sources).rounds.empty());
  EXPECT_EQ(read_ensemble(folder / "e.h5", folder / "prior.toml", sources).rounds.size(), 1u) << "the same prior";
  Prior other = prior;
  other.ranges[1].high = 61;
  io::test::put_bytes(folder / "other.toml", prior_text(other));
  io::test::expect_error<DataError>([&] { read_ensemble(folder / "e.h5", folder / "other.toml", sources); },
                                    "mu 0 to 60 deg, linear; --prior");
  e.rounds.front().sets = 4;
  io::write_ensemble(folder / "less.h5", ensemble_file(e), {});
  EXPECT_THROW(read_ensemble(folder / "less.h5", {}, sources), DataError);
}

TEST(Ensembles, TablesThatAreNoneAreRefused) {
  const io::test::Folder folder;
  std::vector<io::Source> sources;
  const auto mistake = [&](const std::string& text) -> std::string {
    io::test::put_bytes(folder / "e.tsv", text);
    try {
      read_ensemble(folder / "e.tsv", {}, sources);
    } catch (const DataError& error) {
      return std::string(error.what()).substr(std::string(error.what()).find("e.tsv"));
    }
    return "";
  };
  EXPECT_EQ(mistake("id\tE\n1\t1\n1\t2\n"), "e.tsv: row 2: id 1 is there twice");
  EXPECT_EQ(mistake("id\tE\n1.5\t1\n2\t2\n"), "e.tsv: row 1: id 1.5 is no whole number");
  EXPECT_EQ(mistake("id\tE\n1\t1\n2\t1\n"), "e.tsv: E has one value only: no range to find it in; give --prior");
  EXPECT_EQ(mistake("id\tE\n"), "e.tsv: has no rows; give a line for each parameter set");
  EXPECT_EQ(mistake("id\n1\n"), "e.tsv: has no parameters beside id; give a column for each");
  EXPECT_EQ(mistake("id\tE\tmu\n1\t1\t2\n2\t3\tnan\n"), "e.tsv: row 2: mu is not finite");
  EXPECT_EQ(mistake("id\tE\tweight\n1\t1\t2\n2\t3\tnan\n"),
            "e.tsv: weight: holds nan; every member needs a finite number");
}

TEST(Ensembles, SetsOutsideOfTheirPriorAreRefused) {
  const io::test::Folder folder;
  const Prior prior{{{"E", "Pa", "modulus", 1e7, 1e11, Scale::log}, {"mu", "deg", "friction", 0, 60, Scale::linear}}};
  io::test::put_bytes(folder / "prior.toml", prior_text(prior));
  const auto read = [&](const std::string& row) {
    io::test::put_bytes(folder / "e.tsv", "id\tE [Pa]\tmu [deg]\n1\t1e9\t30\n" + row);
    std::vector<io::Source> sources;
    return read_ensemble(folder / "e.tsv", folder / "prior.toml", sources);
  };
  EXPECT_EQ(read("2\t1e11\t0\n").size(), 2U) << "the ends belong to it";
  EXPECT_EQ(read("2\t100000000000.00002\t0\n").size(), 2U) << "so does what rounding makes of them";
  io::test::expect_error<DataError>([&] { read("2\t1e308\t30\n"); },
                                    "E of member 2 is 1e+308, outside of its prior, 1e7 to 1e11; take the set out, or "
                                    "widen the prior");
  io::test::expect_error<DataError>([&] { read("7\t1e9\t-0.001\n"); }, "mu of member 7 is -0.001, outside");
}

}  // namespace
}  // namespace soilweave::calibration
