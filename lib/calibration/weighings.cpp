// Calls of assimilate in the history of a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/weighings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/error.h"

namespace soilweave::calibration {
namespace {

const io::InputRecord* input_of(const io::ProvenanceRecord& record, std::string_view role) {
  const auto found = std::find_if(record.inputs.begin(), record.inputs.end(),
                                  [&](const io::InputRecord& input) { return input.role == role; });
  return found == record.inputs.end() ? nullptr : &*found;
}

/// Returns whether a call compared an observable. Without --observe a call compares every column.
bool compared(const std::string& command, const std::string& name) {
  constexpr std::string_view option = " --observe ";
  std::size_t at = command.find(option);
  if (at == std::string::npos) return true;
  for (; at != std::string::npos; at = command.find(option, at + 1)) {
    std::string_view word = std::string_view(command).substr(at + option.size());
    // A word with blanks is quoted.
    if (word.starts_with('\'')) word.remove_prefix(1);
    if (!word.starts_with(name)) continue;
    word.remove_prefix(name.size());
    if (word.empty() || std::string_view("=' ").find(word.front()) != std::string_view::npos) return true;
  }
  return false;
}

}  // namespace

std::vector<Weighing> weighings_of(const io::History& history) {
  std::vector<Weighing> list;
  for (auto at = static_cast<int>(history.size()) - 1; at >= 0;) {
    const io::ProvenanceRecord& record = history[static_cast<std::size_t>(at)];
    if (record.tool != "pf-weight assimilate") break;
    if (const io::InputRecord* table = input_of(record, "observations"))
      list.push_back({table->sha256, record.command});
    const io::InputRecord* ensemble = input_of(record, "ensemble");
    const bool goes_on = (record.command + " ").find(" --continue ") != std::string::npos;
    at = goes_on && ensemble != nullptr ? ensemble->origin : -1;
  }
  return list;
}

void demand_new(const std::vector<Weighing>& weighings, const io::Source& table, const Observations& observed) {
  for (const Weighing& before : weighings)
    for (const Observable& what : observed.observables)
      if (before.sha256 == table.sha256 && compared(before.command, what.name))
        throw DataError(
            fmt::format("{}: {} has weighed these sets already, and would count twice; leave --continue out, or give "
                        "the observations of another test",
                        table.file.string(), what.name));
}

}  // namespace soilweave::calibration
