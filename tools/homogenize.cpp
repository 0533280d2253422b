// homogenize: from grains to continuum. Reads a packing or a run, writes stress, strain and void ratio.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "analysis/bag.h"
#include "analysis/tables.h"
#include "core/error.h"
#include "core/tool.h"
#include "io/files.h"
#include "io/table.h"

namespace {

using namespace soilweave;

struct Homogenize {
  std::filesystem::path input, output;
  std::string state = "all", table = "cell";
  std::vector<std::string> boxes;
  bool tsv = false, copies = false, groups = false, grains = false, tessellation = false;

  void options(tool::Table& t) {
    t.about("homogenize", "stress, strain and void ratio from the grains and contacts of a packing or a run",
            "Love-Weber stress over the cell, over volumes of interest and over each grain; compression positive.");
    t.example("homogenize run.h5 --tsv", "the cell's stress and strain, one row per snapshot, as text");
    t.example("homogenize run.h5 --copies --grains -o fields.h5", "volumes of interest and grains, as a file");
    t.input(input, "INPUT", "packing or run, - for standard input");
    t.choice(table, "table", {"cell", "volumes", "grains", "series", "bag", "yarns", "broken"}, "what --tsv prints");
    t.flag(tsv, "tsv", "print one table as tab-separated text");
    t.option(state, "state", "WHICH", "all, first, last or a number from 0");
    t.option(boxes, "box", "X0,X1,Y0,Y1,Z0,Z1", "volume of interest, m");
    t.flag(copies, "copies", "the copies of a tiled packing as volumes of interest");
    t.flag(groups, "groups", "four copies each along x in the middle of a bag, #1 to #5 of thesis Fig. 3.9");
    t.flag(grains, "grains", "one row per grain");
    t.flag(tessellation, "tessellation", "void ratio of the cell from the power cells, too");
    t.optional_output(output, "fields file to write");
  }

  void validate() const {
    std::vector<std::string> wrong;
    if (!tsv && output.empty()) wrong.emplace_back("nothing to do: give --tsv or -o FILE");
    if (tsv && output == "-") wrong.emplace_back("--tsv and -o - both write to standard output: give one of them");
    if (!analysis::names_states(state))
      wrong.push_back(fmt::format("--state {}: give all, first, last or a number", state));
    for (const std::string& text : boxes) {
      const std::vector<double> b = parse(text);
      if (b.size() != 6 || b[0] >= b[1] || b[2] >= b[3] || b[4] >= b[5])
        wrong.push_back(fmt::format("--box {}: give x, y and z from low to high, as in 0,0.1,0,0.1,0,0.2", text));
    }
    if (table == "volumes" && boxes.empty() && !copies && !groups)
      wrong.emplace_back("--table volumes needs --box, --copies or --groups");
    if (table == "grains" && !grains) wrong.emplace_back("--table grains needs --grains");
    if (!wrong.empty()) throw UsageError(fmt::format("{}", fmt::join(wrong, "\n")));
  }

  void run(const tool::Invocation& invocation) const {
    const io::RunFile file = io::read_states(input);
    io::FieldsFile fields;
    fields.groups = {{"cell", "whole cell, one row per state", {}},
                     {"volumes", "volumes of interest, one row per volume and state", {}},
                     {"grains", "one row per grain and state", {}},
                     {"bag", "soil in geotextile as a whole, one row per state", {}},
                     {"yarns", "one row per yarn and state", {}},
                     {"broken", "broken yarns of the last state", {}}};
    for (const std::size_t n : analysis::chosen_states(state, file.snapshots.size(), input.string()))
      add(file.snapshots.front(), file.snapshots[n], fields);
    if (file.snapshots.back().yarns.size() > 0) analysis::put_broken(fields.groups[5].table, file.snapshots.back());
    if (file.series.rows() > 0) fields.groups.push_back({"series", "the run's own series", file.series});
    if (tsv) print(fields);
    if (!output.empty()) {
      std::erase_if(fields.groups, [](const auto& group) { return group.table.rows() == 0; });
      io::write_fields(output, fields, io::extend({file.source}, invocation));
    }
  }

  void add(const io::Snapshot& first, const io::Snapshot& s, io::FieldsFile& fields) const {
    analysis::put_cell(fields.groups[0].table, s, tessellation);
    if (s.yarns.size() > 0) analysis::put_bag(fields.groups[3].table, s);
    if (table == "yarns") analysis::put_yarns(fields.groups[4].table, s);
    if (boxes.empty() && !copies && !groups && !grains) return;
    const analysis::Local local = analysis::local(first, s);
    std::vector<analysis::Volume> parts;
    if (copies) parts = analysis::copies(s);
    if (groups)
      for (analysis::Volume& group : analysis::groups(s)) parts.push_back(std::move(group));
    for (const std::string& text : boxes) {
      const std::vector<double> b = parse(text);
      parts.push_back(analysis::box(s, {b[0], b[2], b[4]}, {b[1], b[3], b[5]}));
    }
    for (std::size_t k = 0; k < parts.size(); ++k)
      analysis::put_volume(fields.groups[1].table, first, s, static_cast<double>(k), parts[k], local);
    if (grains) analysis::put_grains(fields.groups[2].table, s, local);
  }

  void print(const io::FieldsFile& fields) const {
    for (const auto& group : fields.groups)
      if (group.name == table) {
        std::fputs(io::to_tsv(group.table).c_str(), stdout);
        return;
      }
    throw DataError(fmt::format("{}: has no series: it is a packing, not a run", input.string()));
  }

  static std::vector<double> parse(const std::string& text) {
    std::vector<double> numbers;
    for (const char* at = text.c_str(); *at;) {
      char* end = nullptr;
      numbers.push_back(std::strtod(at, &end));
      if (end == at || (*end && *end != ',')) return {};
      at = *end ? end + 1 : end;
    }
    return numbers;
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::start<Homogenize>(argc, argv); }
