// The help text of a tool.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "core/cli/tool_table.h"
#include "core/text/text.h"

namespace soilweave::tool {
namespace {

constexpr std::size_t screen_width = 100;
constexpr std::size_t widest_label = 30;

std::string label(const Entry& entry) {
  std::string text = entry.letter.empty() ? "" : "-" + entry.letter;
  if (!entry.name.empty()) text += (text.empty() ? "--" : ", --") + entry.name;
  return entry.metavar.empty() ? text : text + " " + entry.metavar;
}

std::string meaning(const Entry& entry) {
  const bool plain = entry.kind == Kind::flag || entry.standard.empty();
  return plain ? entry.sentence : fmt::format("{} [{}]", entry.sentence, entry.standard);
}

using Row = std::pair<std::string, std::string>;

void append_rows(std::string& text, std::string_view title, const std::vector<Row>& rows, std::size_t column) {
  if (rows.empty()) return;
  text += fmt::format("{}:\n", title);
  for (const auto& [left, right] : rows) {
    const std::vector<std::string> lines = wrapped(right, screen_width - column - 4);
    const bool fits = left.size() <= column;
    if (!fits) text += fmt::format("  {}\n", left);
    for (std::size_t i = 0; i < lines.size(); ++i)
      text += fmt::format("  {:<{}}  {}\n", i == 0 && fits ? left : "", column, lines[i]);
  }
}

std::string synopsis(const Table::Impl& table) {
  std::string text = table.name + (table.verbs.empty() ? " [OPTION]..." : " VERB [OPTION]...");
  for (const Positional& place : table.inputs) {
    if (!table.verbs.empty()) break;
    const std::string file = place.name + (place.many ? "..." : "");
    text += place.required ? " " + file : " [" + file + "]";
  }
  if (table.output_required) text += " -o FILE";
  return text;
}

std::vector<Row> option_rows(const Table::Impl& table, bool general) {
  std::vector<Row> rows;
  for (const Entry& entry : table.options)
    if (entry.general == general) rows.emplace_back(label(entry), meaning(entry));
  return rows;
}

}  // namespace

const std::vector<Status>& exit_statuses() {
  static const std::vector<Status> statuses{{0, "done"},
                                            {1, "target not reached"},
                                            {64, "wrong usage"},
                                            {65, "bad input data"},
                                            {66, "input missing"},
                                            {69, "this processor is too old"},
                                            {70, "a defect, or broken physics"},
                                            {73, "cannot create the output"},
                                            {74, "reading or writing failed"},
                                            {75, "stopped, resumable"}};
  return statuses;
}

std::string help_text(Table::Impl& table) {
  std::string text = fmt::format("{}: {}\nUsage: {}\n", table.name, table.sentence, synopsis(table));
  if (!table.examples.empty()) text += table.examples.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const auto& [command, sentence] : table.examples) text += fmt::format("  {}\n      {}\n", command, sentence);

  if (!table.verbs.empty())
    for (const std::string& line : wrapped(table.description, screen_width)) text += line + "\n";

  std::vector<Row> files, verbs;
  for (Table& verb : table.verbs) verbs.emplace_back(verb_name(verb), verb.impl().sentence);
  if (table.verbs.empty())
    for (const Positional& place : table.inputs) files.emplace_back(place.name, place.sentence);
  std::vector<Row> own = option_rows(table, false);
  std::vector<Row> general = option_rows(table, true);
  general.emplace_back("-h, --help, --version", "this text; name, version and licence");
  general.emplace_back("--man, --completion", "manual page (pipe it into 'man -l -'); completion script for bash");

  if (table.keys)
    general.emplace_back("--keys [text|json]", fmt::format("every key of {}, also as JSON Schema", table.keys_title));

  std::size_t column = 0;
  for (const auto* rows : {&verbs, &files, &own, &general})
    for (const Row& row : *rows)
      if (row.first.size() <= widest_label) column = std::max(column, row.first.size());
  append_rows(text, fmt::format("Verbs ('{} VERB --help' tells their options)", table.name), verbs, column);
  append_rows(text, "Files", files, column);
  append_rows(text, "Options", own, column);
  append_rows(text, "General", general, column);

  std::string statuses;
  for (const Status& s : exit_statuses())
    statuses += fmt::format("{}{} {}", statuses.empty() ? "" : ", ", s.code, s.meaning);
  for (const std::string& line : wrapped("Exit status: " + statuses, screen_width)) text += line + "\n";
  return text;
}

std::string version_text(const Table::Impl& table) {
  return fmt::format(
      "{} (soilweave) {}\nLicence GPL-3.0-or-later: free software, to change and to pass on; there is no warranty.\n",
      table.name, version);
}

}  // namespace soilweave::tool
