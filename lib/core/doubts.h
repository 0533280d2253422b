// Doubts: results that a tool wrote as told, but that a reader should question. Said once on standard error and kept in
// the output.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace soilweave {

/// A doubt about a result that is written all the same.
struct Doubt {
  /// One word for scripts ("rattlers"), unique in a file.
  std::string key;
  /// Text for people: the finding with number and threshold, and a remedy.
  std::string sentence;

  bool operator==(const Doubt&) const = default;
};

/// Doubts of one run of a tool, in order of appearance.
class Doubts {
 public:
  /// Makes a list that prints nothing: for the library, and for processes that must not speak.
  Doubts() = default;
  /// Makes a list that prints each doubt as "TOOL: doubt: SENTENCE" on standard error. --quiet silences progress, not
  /// doubts. Failures of standard error are ignored.
  explicit Doubts(std::string tool) : tool_(std::move(tool)) {}

  /// Keeps the doubt and prints it, unless its key is there already.
  void add(const Doubt& doubt);
  /// Keeps and says several doubts in order.
  void add_all(const std::vector<Doubt>& doubts);

  /// Returns all doubts so far.
  const std::vector<Doubt>& all() const { return all_; }

 private:
  /// Name of the tool; if empty, nothing is printed.
  std::string tool_;
  /// All doubts so far.
  std::vector<Doubt> all_;
};

}  // namespace soilweave
