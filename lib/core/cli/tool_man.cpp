// The manual page and the shell completion of a tool, from its option table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "core/cli/tool_table.h"
#include "core/text/text.h"

namespace soilweave::tool {
namespace {

/// Returns text with roff escapes, so that backslashes, hyphens and a leading dot or quote print as they are.
std::string roff(std::string_view text) {
  std::string result;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
    line_begins = c == '\n';
  }
  return result;
}

std::string sentence_of(std::string text) {
  if (!text.empty() && text.back() != '.') text += '.';
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string uppercase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string option_man(const Entry& entry) {
  std::string names = entry.letter.empty() ? "" : fmt::format("\\fB\\-{}\\fR", entry.letter);
  if (!entry.name.empty()) names += fmt::format("{}\\fB\\-\\-{}\\fR", names.empty() ? "" : ", ", roff(entry.name));
  if (!entry.metavar.empty()) names += fmt::format(" \\fI{}\\fR", roff(entry.metavar));
  std::string text = fmt::format(".TP\n{}\n{}\n", names, roff(sentence_of(entry.sentence)));
  if (!entry.range.empty()) {
    const std::string why = entry.why.empty() ? "" : fmt::format(" ({})", entry.why);
    text += roff(fmt::format("Must be {}{}.\n", entry.range, why));
  }
  if (entry.kind == Kind::list) text += "May be given several times.\n";
  if (entry.kind != Kind::flag && !entry.standard.empty()) text += roff(fmt::format("Default: {}.\n", entry.standard));
  return text;
}

std::string options_man(const Table::Impl& table) {
  std::string text;
  for (const bool general : {false, true}) {
    const auto listed = [&](const Entry& e) { return e.general == general; };
    if (std::none_of(table.options.begin(), table.options.end(), listed)) continue;
    text += general ? ".SS General\n" : ".SH OPTIONS\n";
    for (const Entry& entry : table.options)
      if (listed(entry)) text += option_man(entry);
  }
  return text;
}

std::string informing_man(const Table::Impl& table) {
  constexpr std::string_view informing =
      ".TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nPrint a summary on one screen.\n"
      ".TP\n\\fB\\-\\-version\\fR\nPrint name, version and licence.\n"
      ".TP\n\\fB\\-\\-man\\fR\nPrint this page as roff source.\n"
      ".TP\n\\fB\\-\\-completion\\fR\nPrint a completion script for bash.\n";
  if (!table.keys) return std::string(informing);
  return std::string(informing) +
         fmt::format(
             ".TP\n\\fB\\-\\-keys\\fR [\\fItext\\fR|\\fIjson\\fR]\nPrint every key of {}, as text or as JSON Schema.\n",
             roff(table.keys_title));
}

std::string files_man(const Table::Impl& table) {
  std::string text;
  for (const Positional& place : table.inputs)
    text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", roff(place.name), roff(sentence_of(place.sentence)));
  return text;
}

/// Returns a verb's section in the page of its tool.
std::string verb_man(const Table::Impl& verb) {
  std::string text = fmt::format(".SH {}\n{}\n", roff(uppercase(verb.name)), roff(sentence_of(verb.sentence)));
  if (!verb.description.empty()) text += ".PP\n" + roff(sentence_of(verb.description)) + "\n";
  text += files_man(verb);
  for (const Entry& entry : verb.options)
    if (entry.name != "quiet") text += option_man(entry);
  return text;
}

std::string words(const std::vector<std::string>& list) { return fmt::format("{}", fmt::join(list, " ")); }

std::string function_name(const Table::Impl& table) {
  std::string function = "_" + table.name;
  for (char& c : function)
    if (c == '-' || c == ' ') c = '_';
  return function;
}

/// Returns the bash function that completes the options of one table.
std::string completion_function(const Table::Impl& table) {
  std::string cases;
  for (const Entry& entry : table.options) {
    if (entry.kind == Kind::flag) continue;
    const std::string names = entry.letter.empty() ? entry.written()
                              : entry.name.empty() ? "-" + entry.letter
                                                   : fmt::format("-{}|{}", entry.letter, entry.written());
    if (entry.kind == Kind::choice)
      cases += fmt::format("    {}) mapfile -t COMPREPLY < <(compgen -W \"{}\" -- \"$current\"); return ;;\n", names,
                           words(entry.choices));
    else if (entry.kind != Kind::file)
      cases += fmt::format("    {}) return ;;\n", names);
  }
  std::vector<std::string> names = table.names();
  for (const std::string& name : table.informing()) names.push_back(name);
  return fmt::format(
      "{0}() {{\n"
      "  local current=\"${{COMP_WORDS[COMP_CWORD]}}\" previous=\"${{COMP_WORDS[COMP_CWORD-1]}}\"\n"
      "  case \"$previous\" in\n{1}    *) ;;\n  esac\n"
      "  if [[ $current == -* ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"{2}\" -- \"$current\")\n"
      "  else\n"
      "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
      "  fi\n"
      "}}\n",
      function_name(table), cases, words(names));
}

}  // namespace

std::string man_text(Table::Impl& table) {
  std::string page = table.name;
  std::replace(page.begin(), page.end(), ' ', '-');
  std::string text = fmt::format(".TH {} 1 \"\" \"soilweave {}\" \"Soilweave\"\n", roff(page), version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", roff(page), roff(table.sentence));
  text += fmt::format(".SH SYNOPSIS\n\\fB{}\\fR {}[\\fIOPTION\\fR]...", roff(table.name),
                      table.verbs.empty() ? "" : "\\fIVERB\\fR ");
  for (const Positional& place : table.inputs) {
    if (!table.verbs.empty()) break;
    const std::string file = fmt::format("\\fI{}\\fR{}", roff(place.name), place.many ? "..." : "");
    text += place.required ? " " + file : " [" + file + "]";
  }
  text += "\n.SH DESCRIPTION\n" + roff(sentence_of(table.description.empty() ? table.sentence : table.description)) +
          "\n" + (table.verbs.empty() ? files_man(table) : "");
  if (table.verbs.empty())
    text += options_man(table);
  else
    text += ".SH OPTIONS\nEach verb has options of its own; these are of them all.\n";
  text += informing_man(table);
  for (Table& verb : table.verbs) text += verb_man(verb.impl());
  if (!table.examples.empty()) text += ".SH EXAMPLES\n";
  for (const auto& [command, sentence] : table.examples)
    text += fmt::format(".PP\n{}\n.PP\n.RS\n.EX\n{}\n.EE\n.RE\n", roff(sentence_of(sentence)), roff(command));
  text += ".SH EXIT STATUS\n";
  for (const Status& status : exit_statuses()) text += fmt::format(".TP\n{}\n{}\n", status.code, status.meaning);
  return text;
}

std::string completion_text(Table::Impl& table) {
  const std::string function = function_name(table);
  std::string text = fmt::format("# bash completion for {}\n", table.name);
  if (table.verbs.empty()) {
    text += completion_function(table);
  } else {
    std::string cases, verbs;
    for (Table& verb : table.verbs) {
      text += completion_function(verb.impl());
      cases += fmt::format("    {}) {} ;;\n", verb_name(verb), function_name(verb.impl()));
      verbs += verb_name(verb) + " ";
    }
    text += fmt::format(
        "{}() {{\n"
        "  if [[ $COMP_CWORD -eq 1 ]]; then\n"
        "    mapfile -t COMPREPLY < <(compgen -W \"{}{}\" -- \"${{COMP_WORDS[1]}}\")\n"
        "    return\n"
        "  fi\n"
        "  case \"${{COMP_WORDS[1]}}\" in\n{}    *) ;;\n  esac\n"
        "}}\n",
        function, verbs, words(table.informing()), cases);
  }
  return text + fmt::format("complete -o filenames -F {} {}\n", function, table.name);
}

}  // namespace soilweave::tool
