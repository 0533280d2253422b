// Replaces single values of a document: --set KEY=VALUE.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <utility>

#include "core/error.h"
#include "core/text/settings_document.h"
#include "core/text/toml_depth.h"

namespace soilweave {
namespace {

using settings_parts::as_table, settings_parts::joined;

/// Returns entry `index` of an array, from text such as "0".
toml::node& entry(toml::array& array, const std::string& index, std::string_view assignment) {
  std::size_t i = 0;
  const auto [end, status] = std::from_chars(index.data(), index.data() + index.size(), i);
  const bool number = status == std::errc() && end == index.data() + index.size();
  if (!number || i >= array.size())
    throw UsageError(fmt::format("--set {}: '{}' is no entry of the list; it has {}, counted from 0", assignment, index,
                                 array.size()));
  return array[i];
}

/// Returns the table or list under one part of a dotted key; makes a missing table.
toml::node& step_into(toml::node& node, const std::string& part, std::string_view assignment) {
  auto* array = node.as_array();
  toml::node* next = array != nullptr ? &entry(*array, part, assignment) : node.as_table()->get(part);
  if (next == nullptr) next = &node.as_table()->insert(part, toml::table{}).first->second;
  if (!next->is_table() && !next->is_array())
    throw UsageError(fmt::format("--set {}: '{}' is a value and holds no keys", assignment, part));
  return *next;
}

/// Parses a TOML value. Text that is not TOML ("100 kPa", hertz-mindlin) becomes a string.
toml::table value_of(std::string_view text) {
  if (const std::string excess = toml_excess(text); !excess.empty())
    throw UsageError(fmt::format("--set: the value has {}", excess.substr(excess.find(' ') + 1)));
  try {
    return toml::parse(fmt::format("value = {}", text));
  } catch (const toml::parse_error&) {
    return toml::table{{"value", text}};
  }
}

void assign(toml::node& place, const std::string& key, toml::table holder, std::string_view assignment) {
  toml::node& value = *holder.get("value");
  if (auto* array = place.as_array()) {
    const toml::node& old = entry(*array, key, assignment);
    const auto at = std::find_if(array->begin(), array->end(), [&](const toml::node& n) { return &n == &old; });
    array->insert(array->erase(at), std::move(value));
  } else {
    place.as_table()->insert_or_assign(key, std::move(value));
  }
}

}  // namespace

void Settings::set(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string key(assignment.substr(0, equals));
  if (equals == std::string_view::npos || key.empty())
    throw UsageError(fmt::format("--set {}: write KEY=VALUE, as in --set stage.0.pressure=1e5", assignment));
  if (!toml_excess(key).empty()) throw UsageError(fmt::format("--set: {} is no key", key.substr(0, 60) + " ..."));
  toml::node* node = &as_table(table_);
  std::size_t at = 0;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; at = dot + 1, dot = key.find('.', at))
    node = &step_into(*node, key.substr(at, dot - at), assignment);
  assign(*node, key.substr(at), value_of(assignment.substr(equals + 1)), assignment);
  document_->assigned[joined(path_, key)] = assignment;
}

}  // namespace soilweave
