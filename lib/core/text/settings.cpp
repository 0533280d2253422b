// Settings over toml++: one shared document, handles to its tables, a list of mistakes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/settings.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/mistakes.h"
#include "core/terminal.h"
#include "core/text/settings_document.h"
#include "core/text/text.h"
#include "core/text/toml_depth.h"
#include "core/text/units.h"

namespace soilweave {

namespace {

using Document = Settings::Document;

using settings_parts::as_table, settings_parts::joined;

std::uint32_t line_of(const toml::node& node) { return node.source().begin.line; }

std::string written(const toml::node& node) {
  if (const auto* number = node.as_floating_point(); number && std::isfinite(number->get()))
    return number_text(number->get());
  std::ostringstream text;
  node.visit([&](const auto& concrete) { text << concrete; });
  return text.str();
}

/// Returns how to give what a node holds as one text: "write \"top\"" for the list ["top"].
std::string text_remedy(const toml::node& node) {
  if (const auto* array = node.as_array(); array && array->size() == 1) return text_remedy((*array)[0]);
  if (const auto* text = node.as_string()) return fmt::format("write \"{}\"", text->get());
  return node.is_value() ? fmt::format("write \"{}\"", written(node)) : "give one text in quotes";
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

bool Settings::has(std::string_view key) const {
  if (document_->recorder) return document_->recorder->has(path_, key);
  return asked_node(*document_, path_, table_, key) != nullptr;
}

bool Settings::sound(std::string_view key) const {
  return std::ranges::none_of(document_->mistakes,
                              [&](const Document::Mistake& m) { return m.key == joined(path_, key); });
}

void Settings::mistake(std::string_view key, std::string_view what) {
  if (document_->recorder || document_->is_unread(path_)) return;
  const toml::table& table = as_table(table_);
  const toml::node* node = key.empty() ? nullptr : table.get(key);
  const std::string full = key.empty() ? path_ : joined(path_, key);
  const std::string message = full.empty() ? std::string(what) : fmt::format("{}: {}", full, what);
  document_->add(full, line_of(node != nullptr ? *node : table), message);
}

double Settings::number(const Parameter& parameter, std::optional<double> fallback) {
  if (document_->recorder) return noted(parameter, Key::Type::number, fallback);
  const toml::node* node = asked_node(*document_, path_, table_, parameter.name);
  if (node == nullptr) {
    if (!fallback) mistake(parameter.name, fmt::format("is missing; give {}", expected(parameter)));
    return fallback.value_or(harmless(parameter));
  }
  document_->note(joined(path_, parameter.name), *node, parameter);
  try {
    return read(*node, parameter);
  } catch (const DataError& error) {
    mistake(parameter.name, error.what());
    return fallback.value_or(harmless(parameter));
  }
}

std::int64_t Settings::integer(const Parameter& parameter, std::optional<std::int64_t> fallback) {
  std::optional<double> standard;
  if (fallback) standard = static_cast<double>(*fallback);
  if (document_->recorder) return std::llround(noted(parameter, Key::Type::integer, standard));
  const std::size_t before = document_->mistakes.size();
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
  if (document_->recorder) {
    const double value = noted(parameter, Key::Type::number, std::nullopt, {std::string(word)});
    return document_->recorder->decide(path_, parameter.name, 2) == 0 ? std::optional(value) : std::nullopt;
  }
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
  if (document_->recorder) {
    const double value = noted(parameter, Key::Type::numbers, std::nullopt, {}, fallback ? list_text(*fallback) : "");
    return fallback.value_or(std::vector<double>{value});
  }
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
        document_->note(joined(path_, parameter.name), (*array)[i], parameter);
      } catch (const DataError& error) {
        mistake(parameter.name, fmt::format("entry {}: {}", i + 1, error.what()));
      }
  return values;
}

std::vector<BareNumber> Settings::bare(std::string_view unit) const {
  const auto found = document_->bare.find(unit);
  return found == document_->bare.end() ? std::vector<BareNumber>{} : found->second;
}

Vec3 Settings::vector(const Parameter& parameter, std::optional<Vec3> fallback) {
  if (document_->recorder) {
    const std::string standard = fallback ? list_text({(*fallback)[0], (*fallback)[1], (*fallback)[2]}) : "";
    const double each = noted(parameter, Key::Type::vector, std::nullopt, {}, standard);
    return fallback.value_or(Vec3::Constant(each));
  }
  if (!has(parameter.name) && fallback) return *fallback;
  const std::size_t before = document_->mistakes.size();
  const std::vector<double> values = numbers(parameter);
  if (values.size() == 3) return {values[0], values[1], values[2]};
  if (document_->mistakes.size() == before)
    mistake(parameter.name, fmt::format("has {} components; a vector has 3", values.size()));
  // This vector has a length, so that callers that need a direction add no second mistake.
  return fallback.value_or(Vec3::Ones());
}

std::optional<Vec3> Settings::vector_or(const Parameter& parameter, std::string_view word) {
  if (document_->recorder) {
    const double each = noted(parameter, Key::Type::vector, std::nullopt, {std::string(word)});
    if (document_->recorder->decide(path_, parameter.name, 2) == 1) return std::nullopt;
    return Vec3::Constant(each);
  }
  const toml::node* node = asked_node(*document_, path_, table_, parameter.name);
  if (const auto* text = node ? node->as_string() : nullptr; text != nullptr) {
    if (text->get() == word) return std::nullopt;
    mistake(parameter.name, fmt::format("{} is neither a vector nor \"{}\"", written(*node), word));
    return Vec3::Zero();
  }
  return vector(parameter);
}

std::string Settings::text(const Word& word, std::optional<std::string> fallback) {
  if (document_->recorder) {
    note_word(word, Key::Type::text, {}, fallback ? fmt::format("\"{}\"", *fallback) : "");
    return fallback.value_or("");
  }
  const std::string_view key = word.name;
  const toml::node* node = asked_node(*document_, path_, table_, key);
  if (node == nullptr) {
    if (!fallback) mistake(key, "is missing; give a text");
  } else if (const auto* text = node->as_string()) {
    return text->get();
  } else {
    mistake(key, fmt::format("{} is not a text; {}", written(*node), text_remedy(*node)));
  }
  return fallback.value_or("");
}

std::string Settings::choice(const Word& word, const std::vector<std::string>& values,
                             std::optional<std::string> fallback) {
  if (document_->recorder) return noted_choice(word, values, fallback, false);
  const std::string_view key = word.name;
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

std::string Settings::kind(const Word& word, const std::vector<std::string>& values) {
  if (document_->recorder) return noted_choice(word, values, std::nullopt, true);
  const std::size_t before = document_->mistakes.size();
  std::string value = choice(word, values);
  if (document_->mistakes.size() > before) document_->unread.insert(path_);
  return value;
}

bool Settings::flag(const Word& word, bool fallback) {
  if (document_->recorder) {
    note_word(word, Key::Type::flag, {}, fallback ? "true" : "false");
    return (document_->recorder->decide(path_, word.name, 2) == 1) != fallback;
  }
  const std::string_view key = word.name;
  const toml::node* node = asked_node(*document_, path_, table_, key);
  if (node == nullptr) return fallback;
  if (const auto* value = node->as_boolean()) return value->get();
  mistake(key, fmt::format("{} is neither true nor false", written(*node)));
  return fallback;
}

Settings Settings::table(std::string_view key) {
  if (document_->recorder) return {document_, joined(path_, key), &document_->root};
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
  if (document_->recorder) return {{document_, joined(path_, key) + "[]", &document_->root}};
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

void Settings::leave() { document_->unread.insert(path_); }

void Settings::finish() const {
  if (document_->recorder) return;
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
