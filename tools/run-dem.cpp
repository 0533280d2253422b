// run-dem: loads a packing along the stages of a scenario and records it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "analysis/doubts/plane_doubts.h"
#include "analysis/tables/bag.h"
#include "analysis/tables/doubts.h"
#include "core/cli/tool.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/stop_signals.h"
#include "dem/run/forecast.h"
#include "dem/run/run.h"
#include "dem/state/perturbed.h"
#include "files/files.h"
#include "files/safe_output.h"
#include "store/bytes.h"

namespace {

using namespace soilweave;

constexpr Parameter perturb{"perturb",
                            "1",
                            0,
                            1,
                            false,
                            "move the grains at random by up to this fraction of the radius",
                            "more would make another packing"};

struct RunDem {
  std::filesystem::path packing, scenario, output;
  std::vector<std::string> overrides;
  double perturbation = 0, interval = 300;
  bool check = false;

  void options(tool::Table& table) {
    table.about(
        "run-dem", "load a packing of grains along the stages of a scenario",
        "Reads a packing (or the last state of a run), applies the contact law and the loading stages of a TOML "
        "scenario, and writes a run: a series with one row per station, snapshots with all contacts, and the "
        "state to go on from. While it is under way its recorded states and checkpoints are in FILE.part; after "
        "SIGTERM, SIGINT, SIGXCPU or SIGHUP it finishes the step, writes a checkpoint and ends with status 75, and the "
        "same command with --resume goes on, as it does after a crash. Of standard output nothing is kept.");
    table.example("run-dem packing.h5 triaxial.toml -o run.h5", "drained triaxial compression");
    table.example("run-dem --check packing.h5 triaxial.toml", "the time it will take, without running");
    table.input(packing, "PACKING", "packing or run to start from, - for standard input");
    table.input(scenario, "SCENARIO", "scenario (TOML)");
    table.output(output, "run to write");
    table.option(overrides, "set", "KEY=VALUE",
                 "replace a value of the scenario, as numerics.damping=0.3; the last for a key counts");
    table.option(perturbation, perturb);
    table.instead_of_output(check, "check", "check the input and say how long the run will take; write nothing");
    table.resume(interval);
    table.seed();
    table.keys("a scenario of run-dem", &dem::scenario_keys);
    table.threads();
  }

  void validate() const {}

  void run(const tool::Invocation& invocation) const {
    if (invocation.seed != 0 && perturbation == 0)
      throw UsageError("--seed has no effect without --perturb R: give both, or neither");
    const io::TextFile text = io::read_text(scenario, "scenario");
    dem::Scenario plan = dem::read_scenario(text.text, scenario.string(), overrides);
    plan.numerics.threads = invocation.threads;
    const io::PackingFile start = io::read_state(packing);
    io::Snapshot state = dem::prepare(start.state, plan);
    dem::demand_apart(state, plan);
    if (perturbation > 0) state = dem::perturbed(state, perturbation, invocation.seed);
    Doubts doubts(invocation.tool);
    const std::vector<Doubt> moved = analysis::moved_plane_doubts(start.state, state, plan);
    if (check) {
      doubts.add_all(moved);
      const dem::Forecast ahead = dem::forecast(state, plan);
      io::write_bytes("-", ahead.text());
      doubts.add_all(dem::plate_doubts(state, plan));
      return doubts.add_all(analysis::doubts_before(state, plan, ahead.begun));
    }
    Progress progress("run-dem", invocation.quiet);
    const ProgressReport report = [&](double done, const std::string& detail) { progress.update(done, detail); };
    const io::History history = io::extend(sources(start, text, plan), invocation, plan.resolved);
    const StopSignals signals;
    io::SafeOutput safe(output, history, invocation);
    if (safe.finished(progress)) return;
    doubts.add_all(moved);
    dem::Observe observe;
    if (analysis::is_reinforced(state))
      observe = [&](const io::Snapshot& now, io::Series& row) { analysis::put_bag(row, now, invocation.threads); };
    dem::Outcome outcome = dem::run(state, plan, report, {safe.part(), interval, &signals}, observe);
    doubts.add_all(dem::plate_doubts(state, plan));
    doubts.add_all(analysis::doubts_after(state, plan, outcome.file));
    outcome.cost.output += safe.write([&] { io::write_run(output, outcome.file, io::with_doubts(history, doubts)); });
    if (output != "-") progress.note("run-dem: " + outcome.cost.line());
  }

  static std::vector<io::Source> sources(const io::PackingFile& start, const io::TextFile& text,
                                         const dem::Scenario& plan) {
    std::vector<io::Source> all = {start.source, text.source};
    all.insert(all.end(), plan.sources.begin(), plan.sources.end());
    return all;
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::start<RunDem>(argc, argv); }
