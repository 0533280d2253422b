// Output of the results of gws-solve.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/output/output.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/text/text.h"
#include "gws/output/report.h"

namespace soilweave::gws {

void Output::declare(tool::Table& table) {
  TableOutput::declare(table, "print tab-separated text in SI units", "fields file to write");
}

void Output::check(std::vector<std::string> mistakes) const {
  TableOutput::check(mistakes);
  io::demand_none(mistakes);
}

std::size_t Output::place_of(const Groups& groups, const std::string& table) const {
  std::size_t place = 0;
  while (place < groups.size() && groups[place].name != table) ++place;
  if (tsv && place == groups.size()) throw DataError(table + ": not identified; see the report without --tsv");
  return place;
}

void Output::put(const Groups& groups, std::size_t chosen, const std::string& text,
                 const std::vector<io::Source>& sources, const std::string& scenario,
                 const tool::Invocation& invocation, const std::vector<Doubt>& doubts) const {
  Doubts said(invocation.tool);
  said.add_all(doubts);
  print(tsv ? groups.at(chosen).table : io::Series(), text);
  if (file.empty()) return;
  const io::History history = io::extend(sources, invocation, scenario);
  io::write_fields(file, {groups, {}}, io::with_doubts(history, said));
}

void check_table(bool tsv, const std::string& name, std::vector<std::string>& mistakes) {
  const std::vector<std::string> known = table_names();
  if (std::ranges::find(known, name) != known.end())
    io::check_table(tsv, name, known.front(), mistakes);
  else
    mistakes.push_back(fmt::format("--table: '{}' is not one of {}{}", name, fmt::join(known, ", "),
                                   nearest(name, known).empty() ? "" : suggestion(name, known)));
}

void refuse_idle(tool::Table& table, const std::int64_t& samples, const bool& sensitivity, const Output& output) {
  table.refuse(
      {"seed"}, [&] { return samples == 0; }, "without --samples");
  table.refuse(
      {"range"}, [&] { return !sensitivity; }, "without --sensitivity");
  table.refuse(
      {"points"}, [&] { return sensitivity && output.file.empty(); }, "beside --sensitivity without -o");
}

void refuse_idle(tool::Table& table, const std::optional<double>& surcharge, const bool& chart) {
  table.refuse(
      {"points"}, [&] { return !chart; }, "without --chart");
  table.refuse(
      {"from", "to"}, [&] { return !chart && !surcharge; }, "without --surcharge or --chart");
}

}  // namespace soilweave::gws
