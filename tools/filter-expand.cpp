// filter-expand: copies of a representative volume fill a bag of woven geotextile.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "analysis/doubts/input_doubts.h"
#include "analysis/doubts/loading_doubts.h"
#include "analysis/doubts/material_doubts.h"
#include "analysis/measure/volume_of_interest.h"
#include "analysis/tables/doubts.h"
#include "core/cli/tool.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/stop_signals.h"
#include "dem/engine/described.h"
#include "files/exchange/table.h"
#include "files/files.h"
#include "files/safe_output.h"
#include "packing/expand/expand.h"
#include "packing/expand/plan.h"
#include "packing/expand/surround_compaction.h"
#include "store/bytes.h"

namespace {

using namespace soilweave;

struct FilterExpand {
  std::filesystem::path packing, plan, output, history;
  std::vector<std::string> overrides;
  double interval = 300;

  void options(tool::Table& table) {
    table.about("filter-expand", "fill a container of geotextile with copies of a packing",
                "Lays copies of a periodic packing side by side, contacts and their memory carried across the copies' "
                "faces, keeps the grains inside a closed surface, lays a woven geotextile on it, and grows the grains "
                "step by step, with equilibrium between, until their volume stands still and they press. A plan with "
                "[surround] puts soil around such a bag, in a periodic cell.");
    table.example("filter-expand packing.h5 bag.toml -o bag.h5", "a bag, ready for run-dem");
    table.input(packing, "PACKING", "representative volume, periodic; for [surround] a bag; - for standard input");
    table.input(plan, "PLAN", "container, geotextile, materials and growth, or surroundings (TOML)");
    table.output(output, "packing with geotextile to write");
    table.also_output(history, "history", "write the measurements of each round as tab-separated text");
    table.option(overrides, "set", "KEY=VALUE",
                 "replace a value of the plan, as growth.factor=1.0002; the last for a key counts");
    table.resume(interval);
    table.keys("a plan of filter-expand", &packing::plan_keys);
    table.threads();
  }

  void validate() const {}

  void run(const tool::Invocation& invocation) const {
    const io::TextFile text = io::read_text(plan, "plan");
    packing::Plan what = packing::read_plan(text.text, plan.string(), overrides);
    what.numerics.threads = invocation.threads;
    if (!history.empty() && !what.growth && !what.surround)
      throw UsageError("--history: " + plan.string() + " has no [growth], so that nothing is measured: leave it out");
    const io::PackingFile volume = io::read_state(packing);
    if (what.surround) return put_around(volume, what, text.source, invocation);
    const io::Snapshot start = [&] {
      Progress laying("filter-expand", invocation.quiet);
      return packing::assemble(volume.state, what, [&](double done) { laying.update(done, "geotextile laid"); });
    }();
    dem::described(start, what.model);
    Progress progress("filter-expand", invocation.quiet);
    const ProgressReport report = [&](double done, const std::string& detail) { progress.update(done, detail); };
    std::vector<io::Source> sources = {volume.source, text.source};
    sources.insert(sources.end(), what.sources.begin(), what.sources.end());
    const io::History past = io::extend(sources, invocation, what.resolved);
    Doubts doubts(invocation.tool);
    doubts.add_all(analysis::material_doubts(start, what.model, what.numerics.gravity));
    if (what.growth) doubts.add_all(analysis::mesh_doubts(start));
    if (what.growth)
      doubts.add_all(analysis::tolerance_doubts("growth.unbalanced_force", what.growth->unbalanced_force));
    const StopSignals signals;
    io::demand_no_input(history, past, "--history");
    io::SafeOutput safe(output, past, invocation);
    if (safe.finished(progress)) return demand_history();
    if (what.growth && what.container)
      packing::aim(*what.growth, start, analysis::void_ratio(volume.state), *what.container, what.soil_depth());
    if (!what.growth) {
      doubts.add_all(analysis::bag_doubts(start));
      return void(safe.write([&] { io::write_packing(output, start, io::with_doubts(past, doubts)); }));
    }
    packing::Grown grown =
        packing::grow(start, what.model, what.numerics, *what.growth, report, {safe.part(), interval, &signals});
    if (!history.empty()) io::write_bytes(history, io::to_tsv(grown.history));
    doubts.add_all(packing::filling_doubts(*what.growth, grown.fill));
    doubts.add_all(analysis::bag_doubts(grown.state));
    grown.cost.output += safe.write([&] { io::write_packing(output, grown.state, io::with_doubts(past, doubts)); });
    if (output == "-") return;
    progress.note(fmt::format("filter-expand: {} grains, {}", start.grains.size(), grown.fill.text()));
    progress.note("filter-expand: " + grown.cost.line());
  }

 private:
  // Throws CannotCreate if the measurements are missing, because a finished output does not hold them.
  void demand_history() const {
    std::error_code ignored;
    if (history.empty() || std::filesystem::exists(history, ignored)) return;
    throw CannotCreate(
        fmt::format("{}: cannot be written, for {} is finished and holds no measurements: leave out "
                    "--history, or give --force in place of --resume",
                    history.string(), output.string()));
  }

  static void demand_met(const std::vector<Doubt>& missed, const packing::Surround& how) {
    if (missed.empty() || !how.missed_is_error) return;
    std::vector<std::string> sentences;
    for (const Doubt& doubt : missed) sentences.push_back(doubt.sentence);
    throw TargetNotReached(fmt::format("{}", fmt::join(sentences, "; ")));
  }

  void put_around(const io::PackingFile& reinforced, const packing::Plan& what, const io::Source& text,
                  const tool::Invocation& invocation) const {
    const packing::Surrounded cell = packing::surround(reinforced.state, *what.surround, what.density);
    dem::described(cell.state, what.model);
    std::vector<Doubt> about = analysis::material_doubts(cell.state, what.model, what.numerics.gravity);
    for (Doubt& doubt : analysis::bare_stress_doubts(what.bare_stresses)) about.push_back(std::move(doubt));
    const double unbalanced = what.surround->recipe.tolerances.unbalanced_force;
    for (Doubt& doubt : analysis::tolerance_doubts("surround.unbalanced_force", unbalanced)) about.push_back(doubt);
    Progress progress("filter-expand", invocation.quiet);
    const ProgressReport report = [&](double done, const std::string& detail) { progress.update(done, detail); };
    std::vector<io::Source> sources = {reinforced.source, text};
    sources.insert(sources.end(), what.sources.begin(), what.sources.end());
    const io::History past = io::extend(sources, invocation, what.resolved);
    const StopSignals signals;
    io::demand_no_input(history, past, "--history");
    io::SafeOutput safe(output, past, invocation);
    if (safe.finished(progress)) {
      demand_history();
      // The last record of a finished cell holds the missed targets, and the doubts about its materials.
      std::vector<Doubt> missed = io::read_history(output).back().doubts;
      std::erase_if(missed, [&](const Doubt& doubt) { return std::ranges::find(about, doubt) != about.end(); });
      return demand_met(missed, *what.surround);
    }
    Doubts said(invocation.tool);
    said.add_all(about);
    packing::CompactedCell done = packing::compact_around(cell, *what.surround, what.model, what.numerics, report,
                                                          {safe.part(), interval, &signals});
    // If missed targets are an error, the error's message names them.
    if (!what.surround->missed_is_error) said.add_all(done.missed);
    Doubts doubts;
    doubts.add_all(about);
    doubts.add_all(done.missed);
    if (!history.empty()) io::write_bytes(history, io::to_tsv(packing::table(done)));
    done.result.cost.output +=
        safe.write([&] { io::write_packing(output, done.result.state, io::with_doubts(past, doubts)); });
    if (output != "-") {
      progress.note("filter-expand: placed: " + done.before.text());
      progress.note("filter-expand: compacted: " + done.after.text());
      progress.note("filter-expand: " + done.result.cost.line());
    }
    demand_met(done.missed, *what.surround);
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::start<FilterExpand>(argc, argv); }
