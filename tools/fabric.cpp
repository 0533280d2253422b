// fabric: arrangement of contacts and forces. Reads a packing or a run, writes fabric tensors, rose and histogram.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

#include "analysis/measure/fabric_doubts.h"
#include "analysis/tables/bag.h"
#include "analysis/tables/tables.h"
#include "core/cli/tool.h"
#include "core/error.h"
#include "files/exchange/state_choice.h"
#include "files/exchange/table.h"
#include "files/exchange/table_output.h"
#include "files/files.h"

namespace {

using namespace soilweave;

constexpr std::int64_t usual_classes = 36;
constexpr Parameter classes_parameter{
    "classes", "1", 8, 360, false, "classes of the full circle in the rose, of spheres a multiple of 4"};

struct FabricTool {
  std::filesystem::path input, output;
  std::string state = "all", table = "fabric", columns;
  std::int64_t classes = usual_classes;
  bool tsv = false, soil = false;

  void options(tool::Table& t) {
    t.about("fabric", "fabric tensors, anisotropies, coordination and contact orientation of a packing or a run",
            "Contact-normal and force fabric tensors of thesis Eqs. 3.6-3.9 with a_c, a_n, a_t; q/p is compared with "
            "2/5 (a_c + a_n + 3/2 a_t), a check on both.");
    t.example("fabric run.h5 --tsv", "anisotropies and coordination, one row per snapshot");
    t.example("fabric run.h5 --state first --table rose --tsv", "contact orientation before loading");
    t.input(input, "INPUT", "packing, run or RUN.part of one under way, - for standard input");
    t.choice(table, "table", {"fabric", "histogram", "rose", "chains"}, "table that --tsv prints");
    t.flag(tsv, "tsv", "print one table as tab-separated text");
    t.option(columns, "columns", "NAME,NAME", "columns that --tsv prints, in this order; all of them otherwise");
    t.unrecorded("columns");
    t.option(state, "state", "WHICH", "all, first, last or a number from 0");
    t.option(classes, classes_parameter);
    t.flag(soil, "soil", "use only contacts of soil with soil, in a bag");
    t.optional_output(output, "fields file to write");
  }

  void validate() const {
    std::vector<std::string> wrong;
    io::TableOutput{tsv, output}.check_needed(wrong);
    if (!tsv && !columns.empty()) wrong.emplace_back("--columns belongs to --tsv: give both");
    io::check_table(tsv, table, "fabric", wrong);
    if (tsv && output.empty() && table != "rose" && classes != usual_classes)
      wrong.push_back(
          fmt::format("--classes {}: --table {} has none: give --table rose, or leave it out", classes, table));
    io::check_states(state, wrong);
    io::demand_none(wrong);
  }

  void run(const tool::Invocation& invocation) const {
    const io::RunFile file = io::read_states(input);
    using Group = io::FieldsFile::Group;
    Group fabric{"fabric", "fabric tensors and anisotropies, one row per state", {}};
    Group histogram{"histogram", "grains by number of contacts", {}};
    Group rose{"rose", "contacts by orientation", {}};
    Group chains{"chains", "contacts of the force chains", {}};
    std::vector<Doubt> found;
    const std::vector<std::size_t> chosen = io::chosen_states(state, file.snapshots.size(), input.string());
    for (const std::size_t n : chosen) {
      // Only contacts of reinforced soil count, as in the thesis: with soil, geotextile, plates and fill, or with soil
      // only.
      const io::Snapshot& all = file.snapshots[n];
      demand_quarters(all);
      const bool reinforced = analysis::is_reinforced(all);
      if (soil && !reinforced)
        throw DataError(fmt::format("{}: holds no geotextile and no fill, so that --soil has no effect: leave it out",
                                    input.string()));
      const io::Snapshot s = reinforced ? analysis::soil_contacts(all, soil) : all;
      const bool all_told = !output.empty();
      if (all_told || table == "fabric") std::ranges::copy(analysis::fabric_doubts(s), std::back_inserter(found));
      if (all_told || table == "rose")
        std::ranges::copy(analysis::rose_doubts(s, static_cast<std::size_t>(classes)), std::back_inserter(found));
      analysis::put_fabric(fabric.table, s);
      analysis::put_histogram(histogram.table, s);
      analysis::put_rose(rose.table, s, static_cast<std::size_t>(classes));
      analysis::put_chains(chains.table, s);
    }
    Doubts doubts(invocation.tool);
    doubts.add_all(one_a_key(found, "states"));
    io::FieldsFile fields;
    for (Group* group : {&fabric, &histogram, &rose, &chains}) {
      if (tsv && group->name == table)
        std::fputs(io::to_tsv(analysis::chosen_columns(group->table, columns)).c_str(), stdout);
      if (group->table.rows() > 0) fields.groups.push_back(std::move(*group));
    }
    if (output.empty()) return;
    io::write_fields(output, fields, io::with_doubts(io::extend({file.source}, invocation), doubts));
  }

  // Throws UsageError if the angle from the loading axis, a quarter of the circle, would have classes of another width.
  void demand_quarters(const io::Snapshot& state) const {
    if (classes % 4 == 0 || state.grains.dimension == 2) return;
    throw UsageError(
        fmt::format("--classes {}: the angle from the loading axis takes a quarter of the circle, which has no whole "
                    "number of these classes: give --classes {}",
                    classes, (classes + 2) / 4 * 4));
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::start<FabricTool>(argc, argv); }
