// The document behind Settings: its tables, what was asked of it, and its mistakes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/key_recorder.h"
#include "core/text/settings.h"

namespace soilweave {

/// Content, questions and mistakes of one document.
struct Settings::Document {
  /// A mistake about a key.
  struct Mistake {
    /// Line in the file; 0: in --set.
    std::uint32_t line;
    std::string key, text;
    bool operator<(const Mistake& other) const { return line < other.line; }
  };
  /// Name of the document, for messages.
  std::string name;
  toml::table root;
  /// Targets of handles to absent tables.
  std::deque<toml::table> absent;
  /// Table path -> keys that were read.
  std::map<std::string, std::set<std::string>> asked;
  /// Full key -> the --set that gave it.
  std::map<std::string, std::string> assigned;
  /// Mistakes found so far.
  std::vector<Mistake> mistakes;
  /// Tables whose further mistakes are not reported: their kind is invalid, or the reader left them.
  std::set<std::string> unread;
  /// Full keys that are absent because they were misspelt.
  std::set<std::string> misspelt;
  /// Unit of a key -> numbers of such keys that were given without a unit.
  std::map<std::string, std::vector<BareNumber>, std::less<>> bare;
  /// Set if the document only notes what its reader asks for (keys.h).
  KeyRecorder* recorder = nullptr;

  /// Returns whether a table or one above it is unread.
  bool is_unread(const std::string& path) const {
    return std::any_of(unread.begin(), unread.end(),
                       [&](const std::string& table) { return path == table || path.starts_with(table + "."); });
  }
  /// Notes the number in a node if it was given without a unit.
  void note(const std::string& key, const toml::node& node, const Parameter& parameter) {
    if (const auto value = node.is_number() ? node.value<double>() : std::nullopt)
      bare[std::string(parameter.unit)].push_back({key, *value});
  }
  /// Adds a mistake about a key.
  void add(const std::string& key, std::uint32_t line, std::string_view what) {
    auto by_set = assigned.find(key);
    // A table that only --set made has no line of its own.
    if (by_set == assigned.end() && line == 0)
      by_set = std::find_if(assigned.begin(), assigned.end(),
                            [&](const auto& made) { return made.first.starts_with(key + "."); });
    line = std::max<std::uint32_t>(1, line);
    if (by_set != assigned.end())
      mistakes.push_back({0, key, fmt::format("--set {}: {}", by_set->second, what)});
    else
      mistakes.push_back({line, key, fmt::format("{}:{}: {}", name, line, what)});
  }
};

namespace settings_parts {

/// Returns the table behind a handle.
inline toml::table& as_table(void* table) { return *static_cast<toml::table*>(table); }

/// Returns the dotted path of a key.
inline std::string joined(std::string_view path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

}  // namespace settings_parts

}  // namespace soilweave
