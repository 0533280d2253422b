// Prints keys as text and as JSON Schema.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/text/keys.h"
#include "core/text/text.h"

namespace soilweave {
namespace {

// Returns "[contact.rolling]" or "[[stage]]".
std::string head_of(const std::string& table) {
  const bool list = table.ends_with("[]");
  std::string name = table;
  for (std::size_t at = name.find("[]"); at != std::string::npos; at = name.find("[]")) name.erase(at, 2);
  return list ? "[[" + name + "]]" : "[" + name + "]";
}

std::string in_quotes(std::string_view text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') all += '\\';
    all += c;
  }
  return all + "\"";
}
std::string in_quotes(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + in_quotes(word);
  return all;
}

std::string kind_of(const Key& k) {
  const std::string range = range_text(Parameter{k.name, k.unit, k.low, k.high, k.open});
  std::string unit = k.unit == "1" ? "" : " in " + k.unit;
  if (!range.empty()) unit = ", " + range;
  const std::string words = k.words.empty() ? "" : " or " + in_quotes(k.words);
  switch (k.type) {
    case Key::Type::number:
      return "number" + unit + words;
    case Key::Type::integer:
      return "whole number" + unit + words;
    case Key::Type::numbers:
      return "list of numbers" + unit + words;
    case Key::Type::vector:
      return "three numbers" + unit + words;
    case Key::Type::text:
      return "text";
    case Key::Type::choice:
      return fmt::format("{}", fmt::join(k.words, " | "));
    case Key::Type::flag:
      return "true or false";
  }
  return "";
}

std::string standing(const Key& k) {
  if (k.standard) return "default " + *k.standard;
  return k.required ? "required" : "optional";
}

// Returns the sentence, with the key's conditions in brackets.
std::string meaning(const Key& k) {
  std::string all = k.sentence;
  if (!k.when.empty()) all += fmt::format("{}({})", all.empty() ? "" : " ", fmt::join(k.when, "; "));
  return all;
}

// ---- JSON Schema

std::string bounds(const Key& k) {
  const std::string exclusive = k.open ? "exclusiveM" : "m";
  std::string all;
  if (std::isfinite(k.low)) all += fmt::format(", \"{}inimum\": {}", exclusive, number_text(k.low));
  if (std::isfinite(k.high)) all += fmt::format(", \"{}aximum\": {}", exclusive, number_text(k.high));
  return all;
}

// Returns the schema of a value. A number may be a text with a unit, as in "100 kPa".
std::string value_schema(const Key& k) {
  const std::string number = "\"type\": [\"number\", \"string\"]" + bounds(k);
  switch (k.type) {
    case Key::Type::number:
    case Key::Type::integer:
      return number;
    case Key::Type::numbers:
      return "\"type\": \"array\", \"items\": {" + number + "}";
    case Key::Type::vector:
      return fmt::format("\"type\": {}, \"items\": {{{}}}, \"minItems\": 3, \"maxItems\": 3",
                         k.words.empty() ? "\"array\"" : "[\"array\", \"string\"]", number);
    case Key::Type::text:
      return "\"type\": \"string\"";
    case Key::Type::choice:
      return "\"enum\": [" + in_quotes(k.words) + "]";
    case Key::Type::flag:
      return "\"type\": \"boolean\"";
  }
  return "";
}

std::string property(const Key& k) {
  std::string text = "{" + value_schema(k);
  if (const std::string about = meaning(k); !about.empty()) text += ", \"description\": " + in_quotes(about);
  if (k.standard) text += ", \"default\": " + *k.standard;
  return text + "}";
}

// A table of the document, with its keys and its tables.
struct TableSchema {
  std::vector<const Key*> keys;
  std::vector<std::string> names;  // names of `tables`, with [] for an array of tables
  std::vector<TableSchema> tables;

  TableSchema& at(std::string_view path);
  std::string schema(const std::string& indent) const;
  std::string demands() const;
};

TableSchema& TableSchema::at(std::string_view path) {
  if (path.empty()) return *this;
  const std::size_t dot = path.find('.');
  const std::string name(path.substr(0, dot));
  const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  if (place == names.size()) names.push_back(name), tables.emplace_back();
  return dot == std::string_view::npos ? tables[place] : tables[place].at(path.substr(dot + 1));
}

// Returns the schema of required keys: those always required, and those required with one value of a choice.
std::string TableSchema::demands() const {
  std::map<std::string, std::vector<std::string>> by_condition;
  for (const Key* k : keys)
    if (k->required && k->when.size() <= 1) by_condition[k->when.empty() ? "" : k->when.front()].push_back(k->name);
  std::string all, cases;
  for (const auto& [condition, names] : by_condition) {
    if (condition.empty()) {
      all += ", \"required\": [" + in_quotes(names) + "]";
      continue;
    }
    const std::size_t equals = condition.find(" = ");
    const std::string key = condition.substr(0, equals), value = condition.substr(equals + 3);
    if (key.find('.') != std::string::npos || value.find(", ") != std::string::npos) continue;
    cases += fmt::format(
        "{}{{\"if\": {{\"properties\": {{{}: {{\"const\": {}}}}}, \"required\": [{}]}}, \"then\": "
        "{{\"required\": [{}]}}}}",
        cases.empty() ? "" : ", ", in_quotes(key), in_quotes(value), in_quotes(key), in_quotes(names));
  }
  return cases.empty() ? all : all + ", \"allOf\": [" + cases + "]";
}

std::string TableSchema::schema(const std::string& indent) const {
  std::vector<std::string> rows;
  for (auto k = keys.begin(); k != keys.end(); ++k) {
    const auto same = [&](const Key* other) { return other->name == (*k)->name; };
    if (std::any_of(keys.begin(), k, same)) continue;
    std::string values;
    for (const Key* other : keys)
      if (same(other)) values += (values.empty() ? "" : ", ") + property(*other);
    if (std::count_if(keys.begin(), keys.end(), same) > 1) values = "{\"anyOf\": [" + values + "]}";
    rows.push_back(in_quotes((*k)->name) + ": " + values);
  }
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string& name = names[i];
    const bool list = name.ends_with("[]");
    const std::string inner = tables[i].schema(indent + "  ");
    rows.push_back(in_quotes(list ? name.substr(0, name.size() - 2) : name) + ": " +
                   (list ? "{\"type\": \"array\", \"items\": " + inner + "}" : inner));
  }
  std::string text = "{\"type\": \"object\", \"additionalProperties\": false" + demands() + ", \"properties\": {";
  for (std::size_t i = 0; i < rows.size(); ++i) text += (i ? ",\n" : "\n") + indent + "  " + rows[i];
  return text + "\n" + indent + "}}";
}

}  // namespace

std::string keys_as_text(const std::vector<Key>& keys) {
  std::size_t widest = 0;
  for (const Key& k : keys) widest = std::max(widest, k.name.size());
  std::string text;
  std::vector<std::string> tables;
  for (const Key& k : keys)
    if (std::find(tables.begin(), tables.end(), k.table) == tables.end()) tables.push_back(k.table);
  for (const std::string& table : tables) {
    if (!table.empty()) text += (text.empty() ? "" : "\n") + head_of(table) + "\n";
    for (const Key& k : keys)
      if (k.table == table)
        text += fmt::format("{:<{}}  {}; {}: {}\n", k.name, widest, kind_of(k), standing(k), meaning(k));
  }
  return text;
}

std::string keys_as_schema(const std::vector<Key>& keys, const std::string& title) {
  TableSchema root;
  for (const Key& k : keys) root.at(k.table).keys.push_back(&k);
  std::string text = root.schema("");
  return "{\"$schema\": \"https://json-schema.org/draft/2020-12/schema\", \"title\": " + in_quotes(title) + ", " +
         text.substr(1) + "\n";
}

}  // namespace soilweave
