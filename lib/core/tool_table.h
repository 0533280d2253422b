// Inside of tool::Table: the entries that parsing, help, man page, completion and provenance are made from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/tool.h"

namespace soilweave::tool {

enum class Kind { value, flag, choice, file, list };

struct Entry {
  Kind kind = Kind::value;
  std::string name;      // with hyphens, "void-ratio"; empty where there is only a letter
  std::string letter;    // "n" for -n
  std::string metavar;   // what stands for the value in help: the unit, or what kind of text
  std::string sentence;  // without a full stop
  std::string standard;  // the default as text; empty: none
  std::string range;     // "from 0 to 1", with unit
  std::string why;       // why the range is what it is
  std::vector<std::string> choices;
  bool general = false;                                                  // listed after the tool's own options
  bool recorded = true;                                                  // part of Invocation::command
  bool writes = false;                                                   // names a file to be written
  std::vector<std::string> given;                                        // raw values, in order
  std::function<std::optional<std::string>(const std::string&)> assign;  // the mistake, if any
  std::function<std::string()> value;                                    // canonical text of the field now

  std::string written() const { return name.empty() ? "-" + letter : "--" + name; }
};

struct Positional {
  std::string name, sentence;
  bool required = true, many = false;
  std::function<void(const std::string&)> assign;
  std::vector<std::string> given;
};

struct Table::Impl {
  std::string name, sentence, description;
  std::vector<std::pair<std::string, std::string>> examples;
  std::vector<Positional> inputs;
  std::deque<Entry> options;  // a deque: references stay good while options are added
  std::filesystem::path* output = nullptr;
  bool output_required = false, output_is_folder = false;
  const bool* no_output = nullptr;  // the flag with which nothing is written
  bool understood = true;           // false: an option is unknown, so what the user means is not known as a whole
  std::deque<Table> verbs;          // of a tool that has verbs: their tables, for what it says about itself
  Invocation invocation;

  Entry& add(std::string_view name, Kind kind, std::string_view sentence);
  bool has(std::string_view name) const;
  bool writes() const { return output != nullptr && !(no_output && *no_output); }
  std::vector<std::string> names() const;  // as typed, --long or -l
};

/// Which of the informing options was asked for; the tool then does nothing else.
enum class Ask { nothing, help, version, man, completion };

/// The last word of a table's name: what the user types.
std::string verb_name(Table& verb);

/// Reads the arguments into the fields. Returns what was asked; every mistake is appended to `mistakes`.
Ask parse(Table::Impl& table, int argc, char** argv, std::vector<std::string>& mistakes);

/// Everything about files that can be known before the work. Throws MissingInput, DataError for inputs; CannotCreate
/// for outputs: no place for one, one that exists without --force, one that is an input or another output.
void check_files(const Table::Impl& table);

/// Tool and result-relevant options that differ from their defaults, in table order, quoted for a shell where needed.
std::string canonical_command(const Table::Impl& table);

std::string help_text(Table::Impl& table);
std::string version_text(const Table::Impl& table);
/// man(7) source. The same table gives the same bytes.
std::string man_text(Table::Impl& table);
/// bash source: completes option names, choices and files.
std::string completion_text(Table::Impl& table);

struct Status {
  int code;
  const char* meaning;
};
/// The exit statuses of every tool, in ascending order.
const std::vector<Status>& exit_statuses();

}  // namespace soilweave::tool
