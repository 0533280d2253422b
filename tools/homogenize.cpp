// homogenize: from grains to continuum. Reads a packing or a run, writes stress, strain and void ratio.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/measure/fabric_doubts.h"
#include "analysis/tables/bag.h"
#include "analysis/tables/doubts.h"
#include "analysis/tables/tables.h"
#include "analysis/tables/volume_choice.h"
#include "core/cli/tool.h"
#include "core/error.h"
#include "files/exchange/state_choice.h"
#include "files/exchange/table.h"
#include "files/exchange/table_output.h"
#include "files/files.h"
#include "packing/expand/run_tables.h"

namespace {

using namespace soilweave;

using Group = io::FieldsFile::Group;

/// Tables of a file, in the file's order, with their names for --table. Tables without rows are not written.
struct Tables {
  Group cell{"cell", "whole cell, one row per state", {}};
  Group volumes{"volumes", "volumes of interest, one row per volume and state", {}};
  Group grains{"grains", "one row per grain and state", {}};
  Group bag{"bag", "soil in geotextile, or within fill, as a whole, one row per state", {}};
  Group yarns{"yarns", "one row per yarn and state", {}};
  Group broken{"broken", "broken yarns of the last state", {}};
  Group series{"series", "the run's own series", {}};
  std::vector<Group> of_run;  // packing/expand/run_tables.h

  std::vector<Group*> all() {
    std::vector<Group*> groups = {&cell, &volumes, &grains, &bag, &yarns, &broken, &series};
    for (Group& group : of_run) groups.push_back(&group);
    return groups;
  }
};

struct Homogenize {
  std::filesystem::path input, output;
  std::string state = "all", table = "cell", columns;
  analysis::VolumeChoice choice;
  bool tsv = false, list = false, grains = false, yarns = false, tessellation = false;

  void options(tool::Table& t) {
    t.about("homogenize", "stress, strain and void ratio from the grains and contacts of a packing or a run",
            "Love-Weber stress over the cell, over volumes of interest and over each grain; compression positive.");
    t.example("homogenize run.h5 --tsv", "the cell's stress and strain, one row per snapshot, as text");
    t.example("homogenize run.h5 --copies --grains -o fields.h5", "volumes of interest and grains, as a file");
    t.input(input, "INPUT", "packing, run or RUN.part of one under way, - for standard input");
    std::vector<std::string> names = {"cell", "volumes", "grains", "series", "bag", "yarns", "broken"};
    for (const packing::RunTable& one : packing::run_tables()) names.emplace_back(one.name);
    t.choice(table, "table", names, "table that --tsv prints; grains and yarns need no flag then");
    t.flag(tsv, "tsv", "print one table as tab-separated text");
    t.option(columns, "columns", "NAME,NAME", "columns that --tsv prints, in this order; all of them otherwise");
    t.unrecorded("columns");
    t.instead_of_output(list, "list", "print the names of the tables that the file can give, and stop");
    t.option(state, "state", "WHICH", "all, first, last or a number from 0");
    t.option(choice.boxes, "box", "X0,X1,Y0,Y1,Z0,Z1", "volume of interest, m; of disks X0,X1,Y0,Y1");
    t.flag(choice.copies, "copies", "take the copies of a tiled packing as volumes of interest");
    t.flag(choice.groups, "groups",
           "volumes along x in the middle of a bag, #1 to #5 of thesis Fig. 3.9: each has four copies of ten by ten, "
           "or one of five by five");
    t.flag(grains, "grains", "one row per grain");
    t.flag(yarns, "yarns", "one row per yarn of a geotextile");
    t.flag(tessellation, "tessellation", "add the void ratio of the cell from the power cells");
    t.optional_output(output, "fields file to write");
  }

  void validate() const {
    std::vector<std::string> wrong;
    if (!tsv && !list && output.empty()) wrong.emplace_back("nothing to do: give --tsv, --list or -o FILE");
    if (list && tsv) wrong.emplace_back("--list excludes --tsv: give one of them");
    if (list && (state != "all" || !choice.empty() || grains || yarns || tessellation))
      wrong.emplace_back("--list prints names alone: leave --state and the flags of tables out");
    // A file has these two tables where they are named.
    if (table != "grains" && table != "yarns") io::check_table(tsv, table, "cell", wrong);
    if (!tsv && !columns.empty()) wrong.emplace_back("--columns belongs to --tsv: give both");
    io::TableOutput{tsv, output}.check(wrong);
    io::check_states(state, wrong);
    choice.check(wrong);
    if (table == "volumes" && choice.empty()) wrong.emplace_back("--table volumes needs --box, --copies or --groups");
    if (tsv && output.empty()) demand_flags_of_table(wrong);
    io::demand_none(wrong);
  }

  void run(const tool::Invocation& invocation) const {
    const io::RunFile file = io::read_states(input);
    if (list) return print_list(file);
    Tables tables;
    std::vector<Doubt> found;
    for (const std::size_t n : io::chosen_states(state, file.snapshots.size(), input.string()))
      add(file.snapshots.front(), file.snapshots[n], tables, found);
    Doubts doubts(invocation.tool);
    doubts.add_all(one_a_key(found, "states"));
    analysis::put_broken(tables.broken.table, file.snapshots.back());
    tables.series.table = file.series;
    put_of_run(file, tables);
    if (tsv) print(tables, file.snapshots.back(), doubts);
    if (!output.empty()) write(tables, io::with_doubts(io::extend({file.source}, invocation), doubts));
  }

  /// Adds a mistake for each flag that does not apply to the printed table.
  void demand_flags_of_table(std::vector<std::string>& wrong) const {
    using Flag = std::tuple<bool, std::string_view, std::string_view>;
    for (const auto& [given, flag, of] :
         {Flag{!choice.empty(), "--box, --copies or --groups", "volumes"}, Flag{grains, "--grains", "grains"},
          Flag{yarns, "--yarns", "yarns"}, Flag{tessellation, "--tessellation", "cell"}})
      if (given && table != of) wrong.push_back(fmt::format("{} belongs to --table {}: give it, or -o FILE", flag, of));
    const auto is_table = [&](const packing::RunTable& one) { return table == one.name; };
    if (state != "all" && (table == "series" || std::ranges::any_of(packing::run_tables(), is_table)))
      wrong.push_back(fmt::format(
          "--state {}: --table {} has a row for each station of the whole run: leave --state out", state, table));
    if (table == "broken" && state != "all" && state != "last")
      wrong.push_back(fmt::format("--state {}: --table broken is of the last state: leave --state out", state));
  }

  /// Returns whether a table is needed: all tables are written, or this one is printed.
  bool wanted(std::string_view name) const { return !output.empty() || table == name; }

  void add(const io::Snapshot& first, const io::Snapshot& s, Tables& tables, std::vector<Doubt>& found) const {
    if (wanted("cell") || wanted("volumes") || wanted("grains") || wanted("bag"))
      std::ranges::copy(analysis::contact_doubts(s), std::back_inserter(found));
    if (wanted("cell")) analysis::put_cell(tables.cell.table, s, tessellation);
    if (wanted("bag") && analysis::is_reinforced(s)) analysis::put_bag(tables.bag.table, s);
    if (yarns || table == "yarns") analysis::put_yarns(tables.yarns.table, s);
    const std::vector<analysis::Volume> volumes = choice.volumes(s, input.string());
    const bool each_grain = grains || table == "grains";
    if (volumes.empty() && !each_grain) return;
    const analysis::Local local = analysis::local(first, s);
    for (std::size_t k = 0; k < volumes.size(); ++k)
      analysis::put_volume(tables.volumes.table, first, s, static_cast<double>(k), volumes[k], local);
    std::ranges::copy(analysis::volume_doubts(s, volumes), std::back_inserter(found));
    if (each_grain) analysis::put_grains(tables.grains.table, s, local);
  }

  /// Adds the tables that the run provides. Throws DataError if the run lacks data for the table that is printed.
  void put_of_run(const io::RunFile& file, Tables& tables) const {
    for (const packing::RunTable& one : packing::run_tables())
      if ((tsv && table == one.name) || (!output.empty() && one.given_by(file)))
        tables.of_run.push_back({one.name, one.long_name, one.make(file, input.string())});
  }

  /// Prints one line per table: its name for --table, and its content.
  static void print_list(const io::RunFile& file) {
    Tables tables;
    const bool has_series = file.series.rows() > 0, has_yarns = file.snapshots.back().yarns.size() > 0;
    for (const Group* group : tables.all()) {
      if (group == &tables.series && !has_series) continue;
      if ((group == &tables.yarns || group == &tables.broken) && !has_yarns) continue;
      if (group == &tables.bag && !analysis::is_reinforced(file.snapshots.back())) continue;
      const std::string_view also = group == &tables.volumes ? " (with --box, --copies or --groups)" : "";
      fmt::print("{}\t{}{}\n", group->name, group->long_name, also);
    }
    for (const packing::RunTable& one : packing::run_tables())
      if (one.given_by(file)) fmt::print("{}\t{}\n", one.name, one.long_name);
  }

  void print(Tables& tables, const io::Snapshot& last, Doubts& doubts) const {
    for (const Group* group : tables.all())
      if (group->name == table) {
        if (group->table.rows() == 0) explain_absence(table);
        const io::Series chosen = analysis::chosen_columns(group->table, columns);
        const bool of_cell = table == "cell" || table == "series";
        if (of_cell && analysis::lacks_values(chosen)) doubts.add_all(analysis::open_cell_doubts(last, table));
        std::fputs(io::to_tsv(chosen).c_str(), stdout);
      }
  }

  // Throws DataError if a table is empty because the input is of another kind. A run without broken yarns is no error.
  void explain_absence(std::string_view absent) const {
    if (absent == "series")
      throw DataError(fmt::format("{}: has no series: it is a packing, not a run", input.string()));
    if (absent == "bag" || absent == "yarns")
      throw DataError(fmt::format("{}: has no yarns: there is no geotextile in it", input.string()));
  }

  void write(Tables& tables, const io::History& history) const {
    if (yarns && tables.yarns.table.rows() == 0) explain_absence("yarns");
    io::FieldsFile fields;
    for (Group* group : tables.all())
      if (group->table.rows() > 0) fields.groups.push_back(std::move(*group));
    io::write_fields(output, fields, history);
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::start<Homogenize>(argc, argv); }
