// gws-solve: the elastoplastic solution for soil wrapped in a geotextile: response, identification, design.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/cli/tool.h"
#include "core/error.h"
#include "gws/output/options.h"
#include "gws/output/output.h"
#include "gws/output/report.h"
#include "gws/output/series_options.h"
#include "gws/output/tables.h"
#include "gws/solution/secant.h"

namespace {

using namespace soilweave;

struct Respond {
  gws::CaseOptions bag;
  std::optional<double> surcharge;
  std::int64_t points = 20, samples = 0;
  double share = 0.1;
  bool sensitivity = false;
  gws::Output output;

  void options(tool::Table& t) {
    t.about("gws-solve respond", "strains, stresses and hoop tension of a bag under a rising surcharge");
    t.example("gws-solve respond --geotextile PP --surcharge 1000e3", "a table to read, with the bag's capacity");
    t.example("gws-solve respond --geotextile 3PP --lateral-stress 50e3 --tsv > 3PP.tsv", "triaxial, in SI units");
    t.option(surcharge, gws::last_surcharge);
    bag.declare(t);
    t.option(points, gws::points_range);
    t.flag(sensitivity, "sensitivity", "derivatives of capacity and settlement by each constant");
    t.option(share, gws::share_range);
    t.option(samples, gws::samples_range);
    output.declare(t);
    t.seed();
    gws::refuse_idle(t, samples, sensitivity, output);
  }

  void validate() const {
    std::vector<std::string> wrong = bag.mistakes(true);
    if (surcharge) gws::doubt_pressure("surcharge", *surcharge, wrong);
    if (!surcharge && bag.factors.load != 1) wrong.emplace_back("--factor-load multiplies the surcharge: give one too");
    if (sensitivity && samples > 0) wrong.emplace_back("--sensitivity and --samples: give one of them");
    output.check(wrong);
  }

  void run(const tool::Invocation& invocation) const {
    gws::ReadCase read = bag.read();
    gws::Case& c = read.the_case;
    const std::optional<double> asked = read.asked(surcharge);
    c.soil = read.factors.weakened(c.soil).value_or(c.soil);
    c.until = asked;
    c = gws::at_strain_reached(c, asked);
    const gws::Response response(c);
    const auto rows_wanted = static_cast<std::size_t>(points);
    const auto states = c.geotextile.secant_at > 0 ? gws::secant_points(c, rows_wanted) : response.points(rows_wanted);
    gws::Groups groups{{"response", "response of the bag to surcharge", gws::response_table(states, c)}};
    std::string text = read.soil_line() + gws::heading(c, read.soil.name);
    if (sensitivity) {
      const auto rows = gws::sensitivities(c, read.soil, share);
      groups.push_back({"sensitivity", "capacity and settlement with each constant", gws::sensitivity_table(rows)});
      text += gws::describe(rows);
    } else if (samples > 0) {
      const auto bands = gws::monte_carlo(c, read.soil, samples, invocation.seed, points);
      groups.push_back({"bands", "quantiles over constants " + gws::variation(bands), gws::bands_table(bands)});
      text += gws::aligned(gws::readable(bands)) + gws::describe(bands);
    } else {
      text += gws::aligned(gws::readable(states)) + gws::verdict(response, c);
    }
    text += read.conditions(c);
    output.put(groups, groups.size() - 1, text, read.sources, read.scenario, invocation,
               read.response_doubts({c.geotextile.stiffness}, {response.start(), response.last()}));
    gws::demand_reached(response, asked);
  }
};

struct Identify {
  gws::SeriesOptions series;
  std::vector<std::string> assignments;
  std::string soil = "toyoura-gws", table = "constants";
  bool toml = false;
  gws::Output output;

  void options(tool::Table& t) {
    t.about("gws-solve identify", "the constants of a soil from series of bags, with intervals and residuals");
    t.example("gws-solve respond --geotextile PP -o - | gws-solve identify -", "constants back from a response");
    t.example("gws-solve identify PE.tsv PP.tsv 3PP.tsv --toml > soil.toml", "soil for respond; bag.h5 works too");
    series.declare(t);
    t.option(soil, "soil", "NAME|FILE", "constants of the other lines, and to compare with");
    t.option(assignments, "set", "KEY=VALUE", "replace a constant, as failure_line.n=0.08; the last for a key counts");
    t.option(table, "table", "NAME", "table that --tsv prints: constants, increments or a line (near_failure_line)");
    t.flag(toml, "toml", "print the identified soil as a TOML file");
    output.declare(t);
  }

  void validate() const {
    std::vector<std::string> wrong;
    if (toml && (output.tsv || output.file == "-")) wrong.emplace_back("--toml: print one thing at a time");
    series.check(wrong);
    gws::check_table(output.tsv, table, wrong);
    output.check(wrong);
  }

  void run(const tool::Invocation& invocation) const {
    std::vector<io::Source> sources;
    std::string scenario;
    const gws::SoilFile given = gws::find_soil(soil, assignments, sources, scenario);
    const auto bags = series.bags(sources);
    const auto found = series.identified(bags, given, sources);
    const gws::Groups groups = gws::groups_of(found);
    output.put(groups, output.place_of(groups, table),
               toml ? gws::identified_soil(found, bags, series.method(), invocation.command)
                    : gws::describe(found, bags, series.method()),
               sources, scenario, invocation, gws::doubts(found, assignments));
  }
};

struct Design {
  gws::CaseOptions bag;
  std::optional<double> surcharge, settlement;
  double safety = 1, from = 1e3, to = 1e8;
  std::int64_t points = 25;
  bool chart = false;
  gws::Output output;

  void options(tool::Table& t) {
    t.about("gws-solve design", "the geotextile that carries a surcharge, or the surcharge that a bag carries");
    t.example("gws-solve design --surcharge \"300 kPa\" --settlement 0.05 --safety 1.5", "stiffness and strength");
    t.example("gws-solve design --geotextile PP --surcharge 3e5 --chart --from 50e3", "a chart over stiffnesses");
    t.option(surcharge, gws::surcharge_range);
    t.option(settlement, gws::settlement_range);
    t.option(safety, gws::safety_range);
    t.flag(chart, "chart", "capacity, settlement, efficiency over stiffness; geotextiles of one kind");
    t.option(from, gws::lowest_stiffness);
    t.option(to, gws::highest_stiffness);
    t.option(points, gws::points_range);
    bag.declare(t);
    output.declare(t);
    gws::refuse_idle(t, surcharge, chart);
  }

  void validate() const {
    std::vector<std::string> wrong = bag.mistakes(chart || !surcharge);
    if (surcharge) gws::doubt_pressure("surcharge", *surcharge, wrong);
    if (!surcharge && !settlement && !chart)
      wrong.emplace_back("nothing to design for: give --surcharge or --settlement");
    if (from >= to) wrong.emplace_back("--from: must be below --to");
    output.check(wrong);
  }

  void run(const tool::Invocation& invocation) const {
    const gws::ReadCase read = bag.read();
    const gws::Case c = gws::at_strain_reached(read.the_case, std::nullopt);
    const gws::Demand demand{surcharge.value_or(0), settlement.value_or(1), safety * read.factors.load,
                             read.factors.weakened(c.soil)};
    gws::Case answered = c;
    gws::Groups groups;
    std::string text;
    std::vector<Doubt> doubts;
    if (chart) {
      const auto rows = gws::design_chart(c, demand, {from, to}, static_cast<std::size_t>(points));
      groups.push_back({"chart", "capacity and settlement over stiffness", gws::chart_table(rows, c.reduction)});
      text = gws::aligned(gws::readable(rows, c.reduction));
      doubts = read.chart_doubts(rows);
    } else if (surcharge) {
      const gws::Design found = gws::smallest_geotextile(c, demand, {from, to});
      groups.push_back({"design", "smallest geotextile", gws::design_table(found, c.reduction)});
      text = gws::describe(found, demand, c);
      answered.geotextile = found.geotextile;
      doubts = read.doubts({found.geotextile.stiffness}, {found.start, found.factored});
    } else {
      const gws::Allowance found = gws::allowable_surcharge(c, demand.settlement, demand.safety, demand.weakened);
      groups.push_back({"design", "surcharge carried", gws::allowance_table(found)});
      text = gws::describe(found, demand.settlement, demand.safety, c);
      doubts = read.doubts({c.geotextile.stiffness}, {found.limit, found.at});
    }
    text = read.soil_line() + text + read.conditions(answered);
    output.put(groups, 0, text, read.sources, read.scenario, invocation, doubts);
  }
};

}  // namespace

int main(int argc, char** argv) {
  Respond respond;
  Identify identify;
  Design design;
  return tool::start(argc, argv,
                     {"gws-solve",
                      "bearing capacity and settlement of soil wrapped in a geotextile",
                      std::string(gws::assumptions),
                      {{"respond", tool::program(respond)},
                       {"identify", tool::program(identify)},
                       {"design", tool::program(design)}}});
}
