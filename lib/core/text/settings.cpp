// Settings over toml++: one shared document, handles to its tables, a list of mistakes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/settings.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "core/mistakes.h"
#include "core/terminal.h"
#include "core/text/text.h"
#include "core/text/toml_depth.h"
#include "core/text/units.h"

namespace soilweave {

struct Settings::Document {
  struct Mistake {
    std::uint32_t line;
    std::string key, text;
    bool operator<(const Mistake& other) const { return line < other.line; }
  };
  std::string name;
  toml::table root;
  std::deque<toml::table> absent;                      // targets of handles to absent tables
  std::map<std::string, std::set<std::string>> asked;  // table path -> keys that were read
  std::map<std::string, std::string> assigned;         // full key -> the --set that gave it
  std::vector<Mistake> mistakes;
  std::set<std::string> unread;    // tables whose one mistake leaves open which keys they may have
  std::set<std::string> misspelt;  // full keys that are absent because they were misspelt

  bool is_unread(const std::string& path) const {
    return std::any_of(unread.begin(), unread.end(),
                       [&](const std::string& table) { return path == table || path.starts_with(table + "."); });
  }
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

namespace {

using Document = Settings::Document;

toml::table& as_table(void* table) { return *static_cast<toml::table*>(table); }

std::string joined(std::string_view path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

std::uint32_t line_of(const toml::node& node) { return node.source().begin.line; }

std::string written(const toml::node& node) {
  if (const auto* number = node.as_floating_point(); number && std::isfinite(number->get()))
    return number_text(number->get());
  std::ostringstream text;
  node.visit([&](const auto& concrete) { text << concrete; });
  return text.str();
}

/// Returns a value in the parameter's range, so that callers can go on until finish() reports the mistake.
double harmless(const Parameter& parameter) {
  const bool low = std::isfinite(parameter.low), high = std::isfinite(parameter.high);
  if (low && high) return 0.5 * (parameter.low + parameter.high);
  return low ? parameter.low + 1 : high ? parameter.high - 1 : 0;
}

/// Returns what the user may write: "(Pa, from 0 to 1e9 Pa): mean stress of the cell".
std::string expected(const Parameter& parameter) {
  std::string range = range_text(parameter);
  if (range.empty()) range = parameter.unit == "1" ? "a number" : fmt::format("in {}", parameter.unit);
  return parameter.sentence.empty() ? range : fmt::format("{}: {}", range, parameter.sentence);
}

/// Returns the number in a node, in the parameter's unit. Throws DataError that says what is wrong with it.
double read(const toml::node& node, const Parameter& parameter) {
  double value = 0;
  if (const auto* text = node.as_string())
    value = quantity(text->get(), parameter.unit);
  else if (node.is_number())
    value = *node.value<double>();
  else
    throw DataError(fmt::format("{} is not a number", written(node)));
  if (const auto mistake = range_mistake(value, written(node), parameter)) throw DataError(*mistake);
  return value;
}

void find_unknown(Document& document, const std::string& path, const toml::table& table);

void find_unknown(Document& document, const std::string& path, const toml::array& array) {
  for (std::size_t i = 0; i < array.size(); ++i)
    if (const auto* table = array[i].as_table()) find_unknown(document, joined(path, std::to_string(i)), *table);
}

void find_unknown(Document& document, const std::string& path, const toml::table& table) {
  if (document.is_unread(path)) return;
  const std::set<std::string>& asked = document.asked[path];
  const std::vector<std::string> known(asked.begin(), asked.end());
  for (const auto& [key, node] : table) {
    const std::string name(key.str()), full = joined(path, name);
    if (!asked.contains(name)) {
      document.add(full, line_of(node), fmt::format("unknown key '{}'{}", full, suggestion(name, known)));
      const std::string meant = nearest(name, known);
      if (!meant.empty() && !table.contains(meant)) document.misspelt.insert(joined(path, meant));
    } else if (const auto* inner = node.as_table(); inner && document.asked.contains(full)) {
      find_unknown(document, full, *inner);
    } else if (const auto* array = node.as_array(); array && document.asked.contains(joined(full, "0"))) {
      find_unknown(document, full, *array);
    }
  }
}

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

/// Parses a TOML value; text that is none ("100 kPa", hertz-mindlin) stands for itself.
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

toml::node* asked_node(Document& document, const std::string& path, void* table, std::string_view key) {
  document.asked[path].emplace(key);
  return as_table(table).get(key);
}

}  // namespace

Settings::Settings(std::shared_ptr<Document> document, std::string path, void* table)
    : document_(std::move(document)), path_(std::move(path)), table_(table) {
  document_->asked[path_];
}

Settings Settings::parse(std::string_view text, std::string name) {
  auto document = std::make_shared<Document>();
  document->name = std::move(name);
  if (const std::string excess = toml_excess(text); !excess.empty())
    throw DataError(fmt::format("{}:{}", document->name, excess));
  try {
    document->root = toml::parse(text, document->name);
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    throw DataError(fmt::format("{}:{}:{}: {}", document->name, at.line, at.column, error.description()));
  }
  void* root = &document->root;
  return {std::move(document), "", root};
}

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

bool Settings::has(std::string_view key) const { return asked_node(*document_, path_, table_, key) != nullptr; }

void Settings::mistake(std::string_view key, std::string_view what) {
  if (document_->is_unread(path_)) return;
  const toml::table& table = as_table(table_);
  const toml::node* node = key.empty() ? nullptr : table.get(key);
  const std::string full = key.empty() ? path_ : joined(path_, key);
  const std::string message = full.empty() ? std::string(what) : fmt::format("{}: {}", full, what);
  document_->add(full, line_of(node != nullptr ? *node : table), message);
}

double Settings::number(const Parameter& parameter, std::optional<double> fallback) {
  const toml::node* node = asked_node(*document_, path_, table_, parameter.name);
  if (node == nullptr) {
    if (!fallback) mistake(parameter.name, fmt::format("is missing; give {}", expected(parameter)));
    return fallback.value_or(harmless(parameter));
  }
  try {
    return read(*node, parameter);
  } catch (const DataError& error) {
    mistake(parameter.name, error.what());
    return fallback.value_or(harmless(parameter));
  }
}

std::int64_t Settings::integer(const Parameter& parameter, std::optional<std::int64_t> fallback) {
  const std::size_t before = document_->mistakes.size();
  std::optional<double> standard;
  if (fallback) standard = static_cast<double>(*fallback);
  const double value = number(parameter, standard);
  const bool fine = document_->mistakes.size() == before;
  if (fine && value != std::floor(value))
    mistake(parameter.name, fmt::format("{} is not a whole number", number_text(value)));
  // Above 2^53 doubles skip whole numbers; above 2^63 there is no integer.
  constexpr double most = 9007199254740992.0;
  if (fine && std::abs(value) > most)
    mistake(parameter.name, fmt::format("{} is beyond the whole numbers that are read", number_text(value)));
  return std::llround(std::clamp(value, -most, most));
}

std::optional<double> Settings::number_or(const Parameter& parameter, std::string_view word) {
  const toml::node* node = asked_node(*document_, path_, table_, parameter.name);
  if (node == nullptr) {
    mistake(parameter.name, fmt::format("is missing; give \"{}\" or {}", word, expected(parameter)));
    return std::nullopt;
  }
  if (const auto* text = node->as_string(); text != nullptr && text->get() == word) return std::nullopt;
  try {
    return read(*node, parameter);
  } catch (const DataError& error) {
    mistake(parameter.name, fmt::format("{}; or give \"{}\"", error.what(), word));
    return std::nullopt;
  }
}

std::vector<double> Settings::numbers(const Parameter& parameter, std::optional<std::vector<double>> fallback) {
  const toml::node* node = asked_node(*document_, path_, table_, parameter.name);
  if (node == nullptr && fallback) return *fallback;
  std::vector<double> values;
  const toml::array* array = node == nullptr ? nullptr : node->as_array();
  if (node == nullptr)
    mistake(parameter.name, fmt::format("is missing; give a list, each {}", expected(parameter)));
  else if (array == nullptr)
    mistake(parameter.name, fmt::format("{} is not a list; write [{}, ...]", written(*node), written(*node)));
  else
    for (std::size_t i = 0; i < array->size(); ++i) try {
        values.push_back(read((*array)[i], parameter));
      } catch (const DataError& error) {
        mistake(parameter.name, fmt::format("entry {}: {}", i + 1, error.what()));
      }
  return values;
}

Vec3 Settings::vector(const Parameter& parameter, std::optional<Vec3> fallback) {
  if (!has(parameter.name) && fallback) return *fallback;
  const std::size_t before = document_->mistakes.size();
  const std::vector<double> values = numbers(parameter);
  if (values.size() == 3) return {values[0], values[1], values[2]};
  if (document_->mistakes.size() == before)
    mistake(parameter.name, fmt::format("has {} components; a vector has 3", values.size()));
  return fallback.value_or(Vec3::Zero());
}

std::optional<Vec3> Settings::vector_or(const Parameter& parameter, std::string_view word) {
  const toml::node* node = asked_node(*document_, path_, table_, parameter.name);
  if (const auto* text = node ? node->as_string() : nullptr; text != nullptr) {
    if (text->get() == word) return std::nullopt;
    mistake(parameter.name, fmt::format("{} is neither a vector nor \"{}\"", written(*node), word));
    return Vec3::Zero();
  }
  return vector(parameter);
}

std::string Settings::text(std::string_view key, std::optional<std::string> fallback) {
  const toml::node* node = asked_node(*document_, path_, table_, key);
  if (node == nullptr) {
    if (!fallback) mistake(key, "is missing; give a text");
  } else if (const auto* text = node->as_string()) {
    return text->get();
  } else {
    mistake(key, fmt::format("{} is not a text; write \"{}\"", written(*node), written(*node)));
  }
  return fallback.value_or("");
}

std::string Settings::choice(std::string_view key, const std::vector<std::string>& values,
                             std::optional<std::string> fallback) {
  const std::size_t before = document_->mistakes.size();
  if (!has(key) && !fallback) {
    mistake(key, fmt::format("is missing; give one of {}", fmt::join(values, ", ")));
    return values.front();
  }
  const std::string value = text(key, fallback);
  if (document_->mistakes.size() > before) return fallback.value_or(values.front());
  if (std::find(values.begin(), values.end(), value) != values.end()) return value;
  const std::string near = nearest(value, values);
  mistake(key, fmt::format("'{}' is not one of {}{}", value, fmt::join(values, ", "),
                           near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
  return fallback.value_or(values.front());
}

std::string Settings::kind(std::string_view key, const std::vector<std::string>& values) {
  const std::size_t before = document_->mistakes.size();
  std::string value = choice(key, values);
  if (document_->mistakes.size() > before) document_->unread.insert(path_);
  return value;
}

bool Settings::flag(std::string_view key, bool fallback) {
  const toml::node* node = asked_node(*document_, path_, table_, key);
  if (node == nullptr) return fallback;
  if (const auto* value = node->as_boolean()) return value->get();
  mistake(key, fmt::format("{} is neither true nor false", written(*node)));
  return fallback;
}

Settings Settings::table(std::string_view key) {
  toml::node* node = asked_node(*document_, path_, table_, key);
  toml::table* table = node == nullptr ? nullptr : node->as_table();
  if (node != nullptr && table == nullptr) {
    mistake(key, fmt::format("{} is not a table; write [{}] on a line of its own", written(*node), joined(path_, key)));
    document_->unread.insert(joined(path_, key));
  }
  if (table == nullptr) table = &document_->absent.emplace_back();
  return {document_, joined(path_, key), table};
}

std::vector<Settings> Settings::tables(std::string_view key) {
  toml::node* node = asked_node(*document_, path_, table_, key);
  std::vector<Settings> found;
  if (node == nullptr) return found;
  toml::array* array = node->as_array();
  if (array == nullptr || !array->is_array_of_tables()) {
    const std::string full = joined(path_, key);
    mistake(key, fmt::format("is not a list of tables; write [[{}]] on a line of its own before each", full));
    return found;
  }
  for (std::size_t i = 0; i < array->size(); ++i)
    found.push_back({document_, joined(joined(path_, key), std::to_string(i)), (*array)[i].as_table()});
  return found;
}

void Settings::finish() const {
  Document& document = *document_;
  find_unknown(document, "", document.root);
  std::vector<Document::Mistake> mistakes = document.mistakes;
  // A misspelt key is one mistake, not an unknown key plus a missing one.
  std::erase_if(mistakes, [&](const Document::Mistake& m) {
    return std::any_of(document.misspelt.begin(), document.misspelt.end(),
                       [&](const std::string& key) { return m.key == key || m.key.starts_with(key + "."); });
  });
  if (mistakes.empty()) return;
  std::stable_sort(mistakes.begin(), mistakes.end());
  std::string all;
  for (const Document::Mistake& m : mistakes) all += (all.empty() ? "" : "\n") + printable(m.text);
  throw Mistakes(all);
}

std::string Settings::resolved() const {
  std::ostringstream text;
  text << toml::toml_formatter(as_table(table_), toml::format_flags::none) << "\n";
  return text.str();
}

}  // namespace soilweave
