// Every key that a reader of TOML asks for, as data: name, type, unit, range, default, sentence, and when it counts.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A reader describes each key where it reads it. keys_of() gives it a document that notes and answers every question.
// The reader runs again for each other answer, so that all branches are seen:
//
//   const std::vector<Key> keys = keys_of([](Settings& document) { dem::read(document); });
//   print: "[[stage]]  pressure  Pa, above 0  mean stress  (path = isotropic)"
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/parameter.h"

namespace soilweave {

class Settings;

/// One key of a TOML document.
struct Key {
  /// Type of the value.
  enum class Type { number, integer, numbers, vector, text, choice, flag };
  /// Dotted path of its table, with [] after arrays of tables ("stage[]"); root: "".
  std::string table;
  /// Name of the key.
  std::string name;
  /// Type of its value.
  Type type = Type::number;
  /// Unit, meaning, and reason for the range.
  std::string unit = {}, sentence = {}, why = {};
  /// Bounds of a number, in its unit.
  double low = 0, high = 0;
  /// Whether the bounds themselves are excluded.
  bool open = false;
  /// Values of a choice. For another type: words that are allowed instead of a value.
  std::vector<std::string> words = {};
  /// Default as TOML text; nullopt: none, or it follows from other keys.
  std::optional<std::string> standard = std::nullopt;
  /// Whether its table must have it.
  bool required = false;
  /// Conditions under which it is read: "path = triaxial", "contact.law = linear".
  std::vector<std::string> when = {};
};

/// Returns all keys that `read` asks for, by table, in the order of first request.
/// `read` gets an empty document. Errors that it throws end one reading, not the search.
std::vector<Key> keys_of(const std::function<void(Settings&)>& read);

/// Returns the keys as text: a head line for each table, and a line for each key.
std::string keys_as_text(const std::vector<Key>& keys);
/// Returns the keys as a JSON Schema (draft 2020-12), for editors. title: what the document is.
std::string keys_as_schema(const std::vector<Key>& keys, const std::string& title);

}  // namespace soilweave
