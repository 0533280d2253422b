// fem-dem: finite elements whose points are packings of grains, coupled to a geosynthetic of bars.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/tables/tables.h"
#include "core/cli/tool.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/stop_signals.h"
#include "core/text/number_word.h"
#include "fem/run/record.h"
#include "fem/run/run.h"
#include "fem/run/scenario.h"
#include "fem/run/tables.h"
#include "fem/run/timing.h"
#include "files/exchange/state_choice.h"
#include "files/exchange/table.h"
#include "files/exchange/table_output.h"
#include "files/files.h"
#include "files/safe_output.h"
#include "store/bytes.h"

namespace {

using namespace soilweave;

constexpr Parameter take_parameter{.name = "take",
                                   .unit = "1",
                                   .low = 0,
                                   .high = 1e9,
                                   .sentence =
                                       "write the recorded grains of this point as a run, and stop; the first input is "
                                       "then a file of fem-dem"};

struct FemDem {
  std::filesystem::path scenario, mesh, output;
  std::vector<std::filesystem::path> packings;
  std::vector<std::string> overrides;
  std::optional<double> take;
  std::string table, columns, state = "all", place;
  double interval = 300;
  bool check = false;

  void options(tool::Table& t) {
    t.about(
        "fem-dem", "finite elements whose points are packings of grains, beside a geosynthetic of bars",
        "Explicit finite elements in the plane. Every point of integration is a packing of disks that follows the "
        "soil's deformation and gives back its stress, or an elastic or Mohr-Coulomb solid, with which a problem is "
        "set up in seconds. A chain of bars touches the soil's boundary. One packing serves all points, or one is "
        "given for each. While it is under way the run is kept in FILE.part, as run-dem's is.");
    t.example("fem-dem --check pull.toml", "time steps, memory and time it will take, without running");
    t.example("fem-dem pull.toml -o pull.h5", "with packings: fem-dem rods.toml rods.h5 -o pull.h5");
    t.example("fem-dem --table loading pull.h5",
              "a table of a run as text; others: series, elements, nodes, points, bars");
    t.example("fem-dem --table points --near 0.3,0 pull.h5", "history of the soil above the middle of the sheet");
    t.input(scenario, "SCENARIO", "scenario (TOML); with --take and --table a file of fem-dem");
    t.optional_inputs(packings, "PACKING", "packings or runs to start the points from");
    t.optional_output(output, "file to write");
    t.option(mesh, "mesh", "FILE", "mesh of Gmsh, ASCII 2.2 or 4.1, in place of the scenario's rectangle");
    t.option(overrides, "set", "KEY=VALUE",
             "replace a value of the scenario, as time.duration=1; the last for a key counts");
    t.instead_of_output(check, "check", "check the input and say how long the run will take; write nothing");
    t.option(take, take_parameter);
    t.option(table, "table", "NAME", "print a table of a file of fem-dem as tab-separated text, and stop");
    t.option(columns, "columns", "NAME,NAME", "columns that --table prints, in this order; all of them otherwise");
    t.option(state, "state", "WHICH", "states whose rows --table prints: all, first, last or a number from 0");
    t.option(place, "near", "X,Y", "rows of the point or node alone that was nearest to this place, m, at the start");
    t.resume(interval);
    t.refuse(
        {"resume", "checkpoint-every"}, [this] { return take || !table.empty(); }, "beside --take and --table");
    t.keys("a scenario of fem-dem", &fem::scenario_keys);
    t.threads();
  }

  void validate() const {
    if (check + take.has_value() + !table.empty() > 1)
      throw UsageError("--check, --take and --table exclude each other");
    if ((take || !table.empty()) && !(packings.empty() && mesh.empty() && overrides.empty()))
      throw UsageError("--take and --table read one file of fem-dem: leave further inputs, --mesh and --set out");
    if (table.empty() && !(columns.empty() && state == "all" && place.empty()))
      throw UsageError("--columns, --state and --near belong to --table: give it, too");
    std::vector<std::string> wrong;
    io::check_states(state, wrong);
    io::demand_none(wrong);
    if (!place.empty()) parsed_place();
    if (!table.empty() && !output.empty()) throw UsageError("--table prints: leave -o out, and put > FILE at the end");
    if (take && *take != std::floor(*take)) throw UsageError(fmt::format("--take {}: points are whole numbers", *take));
    if (output.empty() && !check && table.empty()) throw UsageError("name the file to write with -o");
  }

  void run(const tool::Invocation& invocation) const {
    if (take) return take_point(invocation);
    if (!table.empty()) return print_table();
    const io::TextFile text = io::read_text(scenario, "scenario");
    std::vector<io::Source> sources;
    std::vector<io::Snapshot> states;
    for (const auto& path : packings) {
      io::PackingFile packing = io::read_state(path);
      sources.push_back(packing.source);
      states.push_back(std::move(packing.state));
    }
    sources.push_back(text.source);
    std::optional<fem::Mesh> given;
    if (!mesh.empty()) {
      const io::TextFile file = io::read_text(mesh, "mesh");
      given = fem::read_gmsh(file.text, mesh.string());
      sources.push_back(file.source);
    }
    fem::Scenario plan = fem::read_scenario(text.text, scenario.string(), overrides, std::move(given));
    plan.model.threads = invocation.threads;
    const fem::Ranks ranks;
    Doubts doubts = ranks.first() ? Doubts("fem-dem") : Doubts();
    doubts.add_all(plan.doubts);
    if (check) return io::write_bytes("-", fem::forecast(plan, states, doubts));
    Progress progress("fem-dem", invocation.quiet || !ranks.first());
    bool begun = false;
    const ProgressReport report = [&](double done, const std::string& detail) {
      if (!std::exchange(begun, true)) progress.note("fem-dem: the mesh is " + fem::extent_text(plan.model.soil.mesh));
      progress.update(done, detail);
    };
    const io::History history = io::with_doubts(io::extend(sources, invocation, plan.resolved), doubts);
    const StopSignals signals;
    std::optional<io::SafeOutput> safe;
    if (ranks.first()) safe.emplace(output, history, invocation);
    if (ranks.told(std::int64_t{safe && safe->finished(progress)}) != 0) return;
    const fem::Outcome outcome =
        fem::run(plan, states, report, {safe ? safe->part() : nullptr, interval, &signals}, history, ranks, doubts);
    if (!safe) return;
    safe->write([&] { io::write_multiscale(output, outcome.file, io::with_doubts(history, doubts)); });
    if (output != "-") progress.note("fem-dem: " + outcome.cost);
  }

 private:
  void take_point(const tool::Invocation& invocation) const {
    const io::MultiscaleFile file = io::read_multiscale(scenario);
    const io::RunFile run = fem::run_of_point(file, static_cast<fem::Index>(*take));
    io::write_run(output, run, io::extend({file.source}, invocation, ""));
  }

  Vec2 parsed_place() const {
    const std::vector<double> numbers = numbers_of_list(place);
    if (numbers.size() != 2) throw UsageError(fmt::format("--near {}: give x and y in m, as in 0.6,1.2", place));
    return {numbers[0], numbers[1]};
  }

  void print_table() const {
    const io::MultiscaleFile file = io::read_multiscale(scenario);
    io::Series chosen = fem::table(file, table, scenario.string());
    if (!place.empty()) chosen = fem::near(file, table, parsed_place());
    if (state != "all") chosen = fem::of_state(chosen, state, table);
    io::write_bytes("-", io::to_tsv(analysis::chosen_columns(chosen, columns)));
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::start<FemDem>(argc, argv); }
