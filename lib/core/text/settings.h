// A TOML document read by described keys. finish() reports all mistakes at once, with file and line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"
#include "core/tensor.h"
#include "core/text/keys.h"

namespace soilweave {

class KeyRecorder;

/// Description of a key whose value is a text, a choice or a flag.
struct Word {
  /// Name of the key.
  std::string_view name;
  /// Meaning, as one sentence without a full stop.
  std::string_view sentence = "";

  constexpr Word(std::string_view key, std::string_view meaning) : name(key), sentence(meaning) {}
  /// A key that another reader has described.
  template <class Text>
  constexpr Word(const Text& key) : name(key) {}
};

/// A number that was given without a unit, as `pressure = 100`: its full key, and its value in the key's own unit.
struct BareNumber {
  std::string key;
  double value;
};

/// Returns numbers as a TOML list: "[1, 2]".
std::string list_text(const std::vector<double>& numbers);

/// Handle to one table of the document. All handles share the document's list of mistakes.
class Settings {
 public:
  /// Parses TOML text. name: path of the document, for messages. Throws DataError.
  static Settings parse(std::string_view text, std::string name);
  /// Returns an empty document that the recorder answers (keys.h).
  static Settings describing(KeyRecorder& recorder);
  /// Applies one --set key=value. Dotted keys reach into tables, "stage.0.pressure" into arrays of tables.
  void set(std::string_view assignment);

  /// Returns whether the key exists, without reading it.
  bool has(std::string_view key) const;
  /// Returns a number in the parameter's unit. Text such as "100 kPa" is converted.
  double number(const Parameter& parameter, std::optional<double> fallback = std::nullopt);
  /// Returns a whole number.
  std::int64_t integer(const Parameter& parameter, std::optional<std::int64_t> fallback = std::nullopt);
  /// Returns a number, or nullopt for the word `word` (as in limit = "none").
  std::optional<double> number_or(const Parameter& parameter, std::string_view word);
  /// Returns a list of numbers in the parameter's unit.
  std::vector<double> numbers(const Parameter& parameter, std::optional<std::vector<double>> fallback = std::nullopt);
  /// Returns three numbers in the parameter's unit.
  Vec3 vector(const Parameter& parameter, std::optional<Vec3> fallback = std::nullopt);
  /// Returns a vector, or nullopt for the word `word` (as in point = "touch").
  std::optional<Vec3> vector_or(const Parameter& parameter, std::string_view word);
  /// Returns a text.
  std::string text(const Word& key, std::optional<std::string> fallback = std::nullopt);
  /// Returns one of the listed values.
  std::string choice(const Word& key, const std::vector<std::string>& values,
                     std::optional<std::string> fallback = std::nullopt);
  /// Returns a choice that decides which other keys the table has. If it is invalid, the table's other mistakes are not
  /// reported.
  std::string kind(const Word& key, const std::vector<std::string>& values);
  /// Returns true or false; the fallback if the key is absent.
  bool flag(const Word& key, bool fallback);

  /// Returns the table, empty if absent.
  Settings table(std::string_view key);
  /// Returns the array of tables, empty if absent.
  std::vector<Settings> tables(std::string_view key);

  /// Leaves the table unread: finish() judges none of its keys.
  void leave();
  /// Returns whether no mistake about `key` was found so far. The value of another one is a mere stand-in.
  bool sound(std::string_view key) const;
  /// Adds a mistake about `key` (or about the table if empty), with file and line.
  void mistake(std::string_view key, std::string_view what);
  /// Throws DataError with all mistakes, unknown keys included. Call it once, after the last key.
  void finish() const;
  /// Returns the numbers read so far, of keys in `unit`, that were given without a unit.
  std::vector<BareNumber> bare(std::string_view unit) const;
  /// Returns the document with --set applied, as TOML text with sorted keys, for provenance.
  std::string resolved() const;

  struct Document;

 private:
  Settings(std::shared_ptr<Document> document, std::string path, void* table);
  // Notes a key for the recorder, and returns a value that it may have.
  double noted(const Parameter& parameter, Key::Type type, std::optional<double> fallback,
               std::vector<std::string> words = {}, std::string standard = "");
  // Notes a key whose value is a word.
  void note_word(const Word& word, Key::Type type, std::vector<std::string> words, std::string standard);
  // Notes a choice, and returns one of its values.
  std::string noted_choice(const Word& word, const std::vector<std::string>& values,
                           const std::optional<std::string>& fallback, bool governs);
  std::shared_ptr<Document> document_;
  // Dotted path of the table; empty for the root.
  std::string path_;
  void* table_;
};

}  // namespace soilweave
