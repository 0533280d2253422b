// Output of the results of gws-solve.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/output/output.h"

#include "core/error.h"

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

}  // namespace soilweave::gws
