// run-dem: loads a packing along the stages of a scenario and records what it does.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/error.h"
#include "core/progress.h"
#include "core/tool.h"
#include "dem/run.h"
#include "io/files.h"

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
  double perturbation = 0;

  void options(tool::Table& table) {
    table.about(
        "run-dem", "load a packing of grains along the stages of a scenario",
        "Reads a packing (or the last state of a run), applies the contact law and the loading stages of a TOML "
        "scenario, and writes a run: a series with one row per station, snapshots with all contacts, and the "
        "state to go on from.");
    table.example("run-dem packing.h5 triaxial.toml -o run.h5", "drained triaxial compression");
    table.example("run-dem packing.h5 triaxial.toml --set stage.0.pressure=0.5e6 -o run.h5", "at another pressure");
    table.input(packing, "PACKING", "packing or run to start from, - for standard input");
    table.input(scenario, "SCENARIO", "scenario (TOML)");
    table.output(output, "run to write");
    table.option(overrides, "set", "KEY=VALUE", "replace one value of the scenario, as in numerics.damping=0.3");
    table.option(perturbation, perturb);
    table.seed();
    table.threads();
  }

  void validate() const {}

  void run(const tool::Invocation& invocation) const {
    const io::TextFile text = io::read_text(scenario, "scenario");
    dem::Scenario plan = dem::read_scenario(text.text, scenario.string(), overrides);
    plan.numerics.threads = invocation.threads;
    const io::PackingFile start = io::read_state(packing);
    io::Snapshot state = dem::prepare(start.state, plan);
    if (perturbation > 0) state = dem::perturbed(state, perturbation, invocation.seed);
    Progress progress("run-dem", invocation.quiet);
    const io::RunFile result =
        dem::run(state, plan, [&](double fraction, const std::string& detail) { progress.update(fraction, detail); });
    io::write_run(output, result, io::extend({start.source, text.source}, invocation, plan.resolved));
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::main<RunDem>(argc, argv); }
