// Parses the arguments of a tool. CLI11 splits them, and the table's entries judge them, so that all mistakes are
// reported.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <optional>

#include "core/cli/tool_table.h"
#include "core/text/text.h"

namespace soilweave::tool {
namespace {

std::string cli_name(const Entry& entry) {
  if (entry.name.empty()) return "-" + entry.letter;
  return entry.letter.empty() ? "--" + entry.name : fmt::format("-{},--{}", entry.letter, entry.name);
}

struct Asked {
  bool help = false, version = false, man = false, completion = false;
  std::optional<std::string> keys;  // form in which the keys are asked for
};

/// Declares the options to CLI11; every value stays text here.
void declare(CLI::App& app, Table::Impl& table, std::vector<std::string>& files, Asked& asked) {
  app.set_help_flag();
  app.allow_extras();
  app.add_flag("-h,--help", asked.help);
  app.add_flag("--version", asked.version);
  app.add_flag("--man", asked.man);
  app.add_flag("--completion", asked.completion);
  if (table.keys)
    app.add_option_function<std::vector<std::string>>(
           "--keys",
           [&asked](const std::vector<std::string>& words) { asked.keys = words.empty() ? "" : words.front(); })
        ->expected(0, 1)
        ->allow_extra_args(false);
  for (Entry& entry : table.options) {
    if (entry.kind == Kind::flag)
      app.add_flag_callback(cli_name(entry), [&entry] { entry.given.emplace_back(); });
    else
      app.add_option(cli_name(entry), entry.given)->allow_extra_args(false);
  }
  app.add_option("files", files);
}

void assign_options(Table::Impl& table, std::vector<std::string>& mistakes) {
  for (Entry& entry : table.options) {
    for (const std::string& text : entry.given)
      if (const auto mistake = entry.assign(text)) mistakes.push_back(fmt::format("{}: {}", entry.written(), *mistake));
    if (entry.kind == Kind::list || entry.given.empty()) continue;
    const std::string& first = entry.given.front();
    const auto other = std::ranges::find_if(entry.given, [&](const std::string& text) { return text != first; });
    if (other != entry.given.end())
      mistakes.push_back(fmt::format("{} is given twice: {} and {}; give one", entry.written(), first, *other));
  }
}

void report_unknown(const Table::Impl& table, const std::vector<std::string>& extras,
                    std::vector<std::string>& mistakes) {
  std::vector<std::string> known = table.names();
  for (const std::string& name : table.informing()) known.push_back(name);
  for (const std::string& extra : extras) {
    const std::string name = extra.substr(0, extra.find('='));
    const std::string near = nearest(name, known);
    const std::string remedy =
        near.empty() ? fmt::format("see '{} --help'", table.name) : fmt::format("did you mean '{}'?", near);
    mistakes.push_back(fmt::format("unknown option '{}'; {}", name, remedy));
  }
}

/// Assigns files to inputs. An input of many files takes all that the inputs after it do not need.
void assign_inputs(Table::Impl& table, const std::vector<std::string>& files, std::vector<std::string>& mistakes) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < table.inputs.size(); ++i) {
    Positional& place = table.inputs[i];
    const std::size_t left = files.size() - at;
    const std::size_t after = table.inputs.size() - i - 1;
    const std::size_t take = place.many ? (left > after ? left - after : 0) : std::min<std::size_t>(left, 1);
    for (std::size_t k = 0; k < take; ++k) place.given.push_back(files[at + k]);
    for (const std::string& file : place.given) place.assign(file);
    at += take;
    if (take == 0 && place.required) mistakes.push_back(fmt::format("{} is missing: {}", place.name, place.sentence));
  }
  for (; at < files.size(); ++at) mistakes.push_back(fmt::format("'{}' is one file too many", files[at]));
}

void check_standard_input(const Table::Impl& table, std::vector<std::string>& mistakes) {
  std::size_t dashes = 0;
  for (const Positional& place : table.inputs) dashes += std::count(place.given.begin(), place.given.end(), "-");
  if (dashes > 1) mistakes.emplace_back("'-' (standard input) can be read once only");
}

/// Refuses the options in `names` that are given although they have no effect, for the reason `why`.
void refuse_given(const Table::Impl& table, const std::vector<std::string_view>& names, std::string_view why,
                  std::vector<std::string>& mistakes) {
  for (const Entry& entry : table.options)
    if (!entry.given.empty() && std::ranges::find(names, entry.name) != names.end())
      mistakes.push_back(fmt::format("{} has no effect {}: leave it out", entry.written(), why));
}

/// Refuses options of outputs where nothing is written, and options that the tool declares to be without effect.
void check_idle(const Table::Impl& table, std::vector<std::string>& mistakes) {
  if (table.output != nullptr && !table.writes()) {
    const std::string why = "beside --" + table.no_output_name;
    return refuse_given(table, {"output", "force", "resume", "checkpoint-every"}, why, mistakes);
  }
  const auto names_file = [](const Entry& entry) {
    const std::string path = entry.writes ? entry.value() : "";
    return !path.empty() && path != "-";
  };
  if (std::ranges::none_of(table.options, names_file))
    refuse_given(table, {"force"}, "without a file to write", mistakes);
  if (table.output != nullptr && *table.output == "-")
    refuse_given(table, {"resume", "checkpoint-every"}, "beside -o -, for nothing is kept of standard output",
                 mistakes);
  for (const Idle& idle : table.idle)
    if (idle.holds()) refuse_given(table, idle.names, idle.why, mistakes);
}

std::string quoted(const std::string& text) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("-_.,:=/+@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

Ask parse(Table::Impl& table, int argc, char** argv, std::vector<std::string>& mistakes) {
  CLI::App app;
  std::vector<std::string> files;
  Asked asked;
  declare(app, table, files, asked);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ArgumentMismatch&) {
    // Every option with a value takes exactly one, so only the last argument can lack it.
    mistakes.push_back(fmt::format("{}: a value is missing; see '{} --help'", argv[argc - 1], table.name));
    return Ask::nothing;
  } catch (const CLI::ParseError& error) {
    mistakes.push_back(fmt::format("{}; see '{} --help'", error.what(), table.name));
    return Ask::nothing;
  }
  if (asked.help) return Ask::help;
  if (asked.version) return Ask::version;
  if (asked.man) return Ask::man;
  if (asked.completion) return Ask::completion;
  if (asked.keys == "json") return Ask::schema;
  if (asked.keys == "text" || asked.keys == "") return Ask::keys;
  if (asked.keys) {
    mistakes.push_back(fmt::format("--keys {}: give text, json or no word", *asked.keys));
    return Ask::nothing;
  }
  const std::vector<std::string> extras = app.remaining();
  report_unknown(table, extras, mistakes);
  assign_options(table, mistakes);
  // The word after an unknown option may be its value, so files are not counted then.
  table.understood = extras.empty();
  if (table.understood) {
    assign_inputs(table, files, mistakes);
    check_standard_input(table, mistakes);
    if (mistakes.empty()) check_idle(table, mistakes);
    if (table.output_required && table.writes() && table.output->empty())
      mistakes.emplace_back("--output is missing: give '-o FILE', or '-o -' for standard output");
  }
  return Ask::nothing;
}

std::string canonical_command(const Table::Impl& table) {
  std::string command = table.name;
  for (const Entry& entry : table.options) {
    if (!entry.recorded) continue;
    if (entry.kind == Kind::list) {
      for (const std::string& text : entry.given) command += fmt::format(" {} {}", entry.written(), quoted(text));
    } else if (const std::string value = entry.value(); value != entry.standard) {
      command += " " + entry.written();
      if (entry.kind != Kind::flag) command += " " + quoted(value);
    }
  }
  return command;
}

}  // namespace soilweave::tool
