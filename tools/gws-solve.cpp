// gws-solve: the elastoplastic solution for soil wrapped in a geotextile: response, identification, design.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/tool.h"
#include "gws/options.h"
#include "gws/respond.h"
#include "gws/tables.h"
#include "io/files.h"
#include "io/table.h"

namespace {

using namespace soilweave;

constexpr Parameter initial_settlement_parameter{
    "initial_settlement", "1", 0, 1, false, "compact the bag by this axial strain first", "at 1 the bag is flat"};
constexpr Parameter initial_surcharge_parameter{
    "initial_surcharge", "Pa", 0, 1e9, true, "compact the bag to this pressure first", "1 GPa is beyond any test"};
constexpr Parameter points_parameter{"points", "1", 1, 1e6, false, "rows of the table, equal steps of settlement"};

struct Respond {
  gws::CaseOptions bag;
  std::optional<double> surcharge, initial_settlement, initial_surcharge;
  std::int64_t points = 20;
  bool tsv = false;
  std::filesystem::path output;

  void options(tool::Table& t) {
    t.about("gws-solve respond", "strains, stresses and hoop tension of a bag under a rising surcharge");
    t.example("gws-solve respond --geotextile PP --surcharge 1000e3", "a table to read, and what the bag bears");
    t.example("gws-solve respond --geotextile 3PP --lateral-stress \"50 kPa\" --tsv", "triaxial, as text in SI units");
    t.option(surcharge, {"surcharge", "Pa", 0, 1e9, true, "end at this pressure; else at the ultimate one",
                         "1 GPa is far beyond any test of soil"});
    bag.declare(t);
    t.option(initial_settlement, initial_settlement_parameter);
    t.option(initial_surcharge, initial_surcharge_parameter);
    t.option(points, points_parameter);
    t.flag(tsv, "tsv", "print tab-separated text in SI units");
    t.optional_output(output, "fields file to write");
  }

  void validate() const {
    std::vector<std::string> wrong = bag.mistakes(true);
    if (tsv && output == "-") wrong.emplace_back("--tsv and -o - both write to standard output: give one of them");
    if (initial_settlement && initial_surcharge)
      wrong.emplace_back("--initial-settlement and --initial-surcharge: give one of them");
    if (!wrong.empty()) throw UsageError(fmt::format("{}", fmt::join(wrong, "\n")));
  }

  void run(const tool::Invocation& invocation) const {
    gws::ReadCase read = bag.read();
    gws::Case& c = read.the_case;
    c.initial_settlement = initial_settlement;
    c.initial_surcharge = initial_surcharge;
    c.until = surcharge;
    const gws::Response response(c);
    const std::vector<gws::Point> states = response.points(static_cast<std::size_t>(points));
    const io::Series table = gws::response_table(states, c);
    if (tsv)
      std::fputs(io::to_tsv(table).c_str(), stdout);
    else if (output != "-")
      fmt::print("{}{}{}", gws::heading(c, read.soil.name), gws::aligned(gws::readable(states)),
                 gws::verdict(response, c));
    if (!output.empty())
      io::write_fields(output, {{{"response", "response of the bag to surcharge", table}}, {}},
                       io::extend(read.sources, invocation, read.scenario));
    if (surcharge && response.failed())
      throw TargetNotReached(fmt::format("{:.6g} Pa are not reached: the bag bears {:.6g} Pa: {}", *surcharge,
                                         response.last().surcharge, gws::reason(response.end())));
  }
};

constexpr std::string_view model =
    "The elastoplastic solution of H. Cheng's dissertation (Hiroshima University, 2016, section 5.3) for a cuboid of "
    "soil wrapped in a geotextile, under vertical pressure and, if asked, lateral stress. It assumes principal "
    "stresses along the axes, uniform in the soil (no friction at the fabric, no corners); q/p and dilatancy on lines "
    "identified by discrete-element analysis of Toyoura sand, unique for all geotextiles; one elastic tension in all "
    "hoops; and, empirically, Young's modulus as a power of the geotextile's stiffness. It knows no unloading, no "
    "creep, no tilting or stacking of bags. Failure is counted at half the strength; loads there lie 20-25 % above "
    "the discrete elements' own, settlements agree. Beyond 53 to 1160 kN/m and 100 kPa of lateral stress it is "
    "untested; a lateral stress makes its beginning too soft.";

}  // namespace

int main(int argc, char** argv) {
  Respond respond;
  return tool::main(argc, argv,
                    {"gws-solve",
                     "bearing capacity and settlement of soil wrapped in a geotextile",
                     std::string(model),
                     {{"respond", tool::program(respond)}}});
}
