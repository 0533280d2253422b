// Doubts: findings on results that were written, but that a reader should question.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace soilweave {

/// One finding that a reader should know.
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
  /// Makes a list that prints nothing.
  Doubts() = default;
  /// Makes a list that prints "TOOL: doubt: SENTENCE" on standard error, even with --quiet.
  /// Failures of standard error are ignored.
  explicit Doubts(std::string tool) : tool_(std::move(tool)) {}

  /// Keeps the doubt and prints it, unless its key is there already.
  void add(const Doubt& doubt);
  /// Keeps and prints several doubts in order.
  void add_all(const std::vector<Doubt>& doubts);

  /// Returns all doubts so far.
  const std::vector<Doubt>& all() const { return all_; }

 private:
  /// Name of the tool; if empty, nothing is printed.
  std::string tool_;
  /// All doubts so far.
  std::vector<Doubt> all_;
};

/// Returns the first doubt of each key. Its sentence tells how many more `things`, such as "states", have one with
/// another sentence, since only the first of a key is said.
std::vector<Doubt> one_a_key(const std::vector<Doubt>& found, const std::string& things);

}  // namespace soilweave
