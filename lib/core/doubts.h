// Doubts: what a tool did as told but a reader should know, said once on standard error and written into the output.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace soilweave {

/// One doubt about a result that is written all the same.
struct Doubt {
  std::string key;       // one word for scripts, "rattlers"; at most one doubt of a key in a file
  std::string sentence;  // for people: what, with number and threshold, and what would mend it

  bool operator==(const Doubt&) const = default;
};

/// The doubts of one run of a tool, in the order in which they came up.
class Doubts {
 public:
  /// Prints nothing: for a library that finds doubts, and for a process that is not the one to speak.
  Doubts() = default;
  /// Prints each doubt as "TOOL: doubt: SENTENCE" on standard error, with --quiet too: that silences progress, not
  /// warnings. A standard error that cannot be written is passed over.
  explicit Doubts(std::string tool) : tool_(std::move(tool)) {}

  /// Keeps the doubt and says it, unless one of this key is there already.
  void add(const Doubt& doubt);
  void add_all(const std::vector<Doubt>& doubts);

  const std::vector<Doubt>& all() const { return all_; }

 private:
  std::string tool_;  // empty: says nothing
  std::vector<Doubt> all_;
};

}  // namespace soilweave
