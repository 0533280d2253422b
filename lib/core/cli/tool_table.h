// Entries of tool::Table, from which parsing, help, man page, completion and provenance are made.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/cli/tool.h"

namespace soilweave::tool {

/// Kind of an option's value.
enum class Kind { value, flag, choice, file, list };

/// One option of a table.
struct Entry {
  /// Kind of option.
  Kind kind = Kind::value;
  /// Long name with hyphens ("void-ratio"); empty if there is only a letter.
  std::string name;
  /// Letter, "n" for -n.
  std::string letter;
  /// Text shown for the value in help: its unit, or the kind of text.
  std::string metavar;
  /// Sentence without a full stop.
  std::string sentence;
  /// Default as text; empty: none.
  std::string standard;
  /// Range with its unit: "from 0 to 1".
  std::string range;
  /// Reason for the range.
  std::string why;
  /// Values of a choice.
  std::vector<std::string> choices;
  /// Whether help lists it after the tool's own options.
  bool general = false;
  /// Whether it is part of Invocation::command.
  bool recorded = true;
  /// Whether it names an output file.
  bool writes = false;
  /// Raw values, in order.
  std::vector<std::string> given;
  /// Returns the mistake, if any.
  std::function<std::optional<std::string>(const std::string&)> assign;
  /// Canonical text of the field's present value.
  std::function<std::string()> value;

  /// Returns the option as a user writes it, for messages.
  std::string written() const { return name.empty() ? "-" + letter : "--" + name; }
};

/// Options that have no effect while a condition holds, and the words that tell the condition.
struct Idle {
  std::vector<std::string_view> names;
  std::function<bool()> holds;
  std::string_view why;
};

/// One positional input, for a single file or for many.
struct Positional {
  std::string name, sentence;
  /// Whether the input must be given; whether it takes any number of files.
  bool required = true, many = false;
  /// Sets the field from a word.
  std::function<void(const std::string&)> assign;
  /// Words as given, in order.
  std::vector<std::string> given;
};

/// Everything declared about a tool, and the values read from its arguments.
struct Table::Impl {
  std::string name, sentence, description;
  /// Commands, each with its sentence.
  std::vector<std::pair<std::string, std::string>> examples;
  /// Positional inputs, in order.
  std::vector<Positional> inputs;
  /// Options; in a deque references stay valid while options are added.
  std::deque<Entry> options;
  /// Field of the output.
  std::filesystem::path* output = nullptr;
  /// Whether the output must be named; whether it is a folder.
  bool output_required = false, output_is_folder = false;
  /// Kind of document whose keys --keys prints.
  std::string keys_title;
  /// Keys that --keys prints; nullptr: the tool has no --keys.
  std::vector<Key> (*keys)() = nullptr;
  /// Flag with which nothing is written, and its name.
  const bool* no_output = nullptr;
  std::string no_output_name;
  /// Options that have no effect under a condition, which is asked after parsing.
  std::vector<Idle> idle;
  /// Whether all options are known; otherwise the rest may be misread.
  bool understood = true;
  /// Option tables of a tool's verbs, for its help.
  std::deque<Table> verbs;
  Invocation invocation;

  /// Adds an option. A name such as "pressure,p" gives it a letter too.
  Entry& add(std::string_view name, Kind kind, std::string_view sentence);
  /// Returns whether the table has an option of this name.
  bool has(std::string_view name) const;
  /// Returns whether this run writes a file.
  bool writes() const { return output != nullptr && !(no_output && *no_output); }
  /// Names as typed, --long or -l.
  std::vector<std::string> names() const;
  /// Returns the options that ask for information, as typed.
  std::vector<std::string> informing() const;
};

/// Option that asks for information; the tool then does nothing else.
enum class Ask { nothing, help, version, man, completion, keys, schema };

/// Returns the last word of a table's name, which the user types.
std::string verb_name(Table& verb);

/// Reads the arguments into the fields and returns the information asked for. Appends every mistake to `mistakes`.
Ask parse(Table::Impl& table, int argc, char** argv, std::vector<std::string>& mistakes);

/// Checks files before the work. Throws MissingInput or DataError for inputs. Throws CannotCreate if an output cannot
/// be made, exists without --force, or is an input or another output.
void check_files(const Table::Impl& table);

/// Returns the tool and its recorded options other than defaults, in table order, quoted for a shell.
std::string canonical_command(const Table::Impl& table);

/// Returns the text of --help.
std::string help_text(Table::Impl& table);
/// Returns the text of --version.
std::string version_text(const Table::Impl& table);
/// Returns man(7) source. Equal tables give equal bytes.
std::string man_text(Table::Impl& table);
/// Returns bash source that completes option names, choices and files.
std::string completion_text(Table::Impl& table);

/// One exit status, as help and manual page describe it.
struct Status {
  /// Number of the status.
  int code;
  /// Meaning in a few words.
  const char* meaning;
};
/// Returns the exit statuses of every tool, in ascending order.
const std::vector<Status>& exit_statuses();

}  // namespace soilweave::tool
