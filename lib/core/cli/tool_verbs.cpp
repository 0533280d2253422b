// Tools of several verbs. The first argument names the verb. Without a verb the tool shows its help or an error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "core/cli/tool_table.h"
#include "core/error.h"
#include "core/text/text.h"

namespace soilweave::tool {
namespace {

std::vector<std::string> verb_names(const Suite& suite) {
  std::vector<std::string> names;
  for (const Suite::Verb& verb : suite.verbs) names.push_back(verb.name);
  return names;
}

/// Fills the tool's own table: its verbs with their first examples.
void describe(Table& table, const Suite& suite, std::filesystem::path& verb) {
  table.about(suite.name, suite.sentence, suite.description);
  table.optional_input(verb, "VERB", fmt::format("one of {}", fmt::join(verb_names(suite), ", ")));
  for (const Suite::Verb& one : suite.verbs) {
    Table& listed = table.impl().verbs.emplace_back();
    one.program.options(listed);
    if (listed.impl().keys) table.keys(listed.impl().keys_title, listed.impl().keys);
    const auto& examples = listed.impl().examples;
    if (!examples.empty()) table.example(examples.front().first, examples.front().second);
  }
}

[[noreturn]] void refuse(const Suite& suite, const std::string& given) {
  const std::vector<std::string> names = verb_names(suite);
  if (given.empty())
    throw UsageError(
        fmt::format("a verb is missing; give one of {}, or see '{} --help'", fmt::join(names, ", "), suite.name));
  if (std::find(names.begin(), names.end(), given) != names.end())
    throw UsageError(fmt::format("{}: the verb comes first: '{} {} ...'", given, suite.name, given));
  throw UsageError(fmt::format("'{}' is no verb{}", given, suggestion(given, names)));
}

}  // namespace

std::string verb_name(Table& verb) { return verb.impl().name.substr(verb.impl().name.rfind(' ') + 1); }

int start(int argc, char** argv, const Suite& suite) {
  for (const Suite::Verb& verb : suite.verbs)
    if (argc > 1 && verb.name == argv[1]) return start(argc - 1, argv + 1, verb.program);
  std::filesystem::path given;
  return start(argc, argv,
               {[&](Table& table) { describe(table, suite, given); }, [&] { refuse(suite, given.string()); }, {}});
}

}  // namespace soilweave::tool
