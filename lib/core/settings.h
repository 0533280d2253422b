// A TOML document read by described keys. Every mistake is collected (unknown keys with the nearest known one, values
// out of range with the range and the reason, wrong types), and finish() reports them all at once with file and line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"
#include "core/tensor.h"

namespace soilweave {

/// One table of the document. Cheap handle; all handles of a document share its list of mistakes.
class Settings {
 public:
  /// name: what error messages call the document (its path). Throws DataError with line and column on bad TOML.
  static Settings parse(std::string_view text, std::string name);
  /// Applies one --set key=value (dotted keys reach into tables; "stage.0.pressure" reaches into arrays of tables).
  void set(std::string_view assignment);

  bool has(std::string_view key) const;
  /// Numbers: bare numbers are in the parameter's unit; strings such as "100 kPa" are converted to it.
  double number(const Parameter& parameter, std::optional<double> fallback = std::nullopt);
  std::int64_t integer(const Parameter& parameter, std::optional<std::int64_t> fallback = std::nullopt);
  /// A number or the word `word` (as in limit = "none"): nullopt for the word.
  std::optional<double> number_or(const Parameter& parameter, std::string_view word);
  std::vector<double> numbers(const Parameter& parameter, std::optional<std::vector<double>> fallback = std::nullopt);
  Vec3 vector(const Parameter& parameter, std::optional<Vec3> fallback = std::nullopt);
  /// A vector or the word `word` (as in point = "touch"): nullopt for the word.
  std::optional<Vec3> vector_or(const Parameter& parameter, std::string_view word);
  std::string text(std::string_view key, std::optional<std::string> fallback = std::nullopt);
  std::string choice(std::string_view key, const std::vector<std::string>& values,
                     std::optional<std::string> fallback = std::nullopt);
  /// A choice that decides which other keys the table has: where it is wrong, nothing more is told of the table.
  std::string kind(std::string_view key, const std::vector<std::string>& values);
  bool flag(std::string_view key, bool fallback);

  Settings table(std::string_view key);                // an empty one where it is absent
  std::vector<Settings> tables(std::string_view key);  // array of tables; empty where absent

  /// Adds a mistake about `key` (or the whole table when empty), in the file:line form of all others.
  void mistake(std::string_view key, std::string_view what);
  /// Throws DataError with every mistake, unknown keys included. Call once, when all keys have been asked for.
  void finish() const;
  /// The document with --set applied, as TOML text with sorted keys: what provenance records.
  std::string resolved() const;

  struct Document;

 private:
  Settings(std::shared_ptr<Document> document, std::string path, void* table);
  std::shared_ptr<Document> document_;
  std::string path_;
  void* table_;
};

}  // namespace soilweave
