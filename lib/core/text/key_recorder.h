// Records which keys a reader of TOML asks for, and supplies their values (keys.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text/keys.h"

namespace soilweave {

/// Records the keys that a reader asks for, over many readings.
///
/// A question with several answers is a decision. A script fixes the first decisions of a reading; later decisions take
/// their first answer. Each untried answer becomes a new script, once for each set of earlier choices.
class KeyRecorder {
 public:
  /// others: whether numbers get a second set of values, which reveals defaults that depend on them.
  explicit KeyRecorder(bool others = false) : others_(others) {}
  /// Returns a small value in the number's range, because readers make grids of such sizes.
  double value(const Parameter& parameter) const;
  /// Begins the next reading. Returns false if every answer has been tried.
  bool begin();
  /// Notes that the reading came to its end without an error.
  void end();

  /// Returns an answer, a number below `answers`, to the question about a key.
  std::size_t decide(std::string_view table, std::string_view key, std::size_t answers);
  /// Returns whether the key exists; the first answer is no.
  bool has(std::string_view table, std::string_view key);
  /// Returns one of the values. governs: whether the choice affects the keys of all tables (Settings::kind).
  std::string choose(std::string_view table, std::string_view key, const std::vector<std::string>& values,
                     bool governs);
  /// Notes a key with the choices made so far.
  void note(Key key);

  /// Returns all keys, with their conditions.
  std::vector<Key> keys() const;

 private:
  /// Value given to a key in the present reading.
  struct Choice {
    std::string table, key, value;
    bool governs;
    std::string name() const { return table.empty() ? key : table + "." + key; }
    /// Returns whether the choice may affect keys of table `other`.
    bool counts_for(std::string_view other) const;
  };
  /// A key and the readings that asked for it.
  struct Noted {
    Key key;
    /// Number of readings that asked for the key.
    std::size_t readings = 0;
    /// Values with which the key was read, by choice.
    std::map<std::string, std::set<std::string>> values;
    /// Number of readings in which each choice came before the key.
    std::map<std::string, std::size_t> times;
  };
  /// Answers to the first decisions of a reading.
  using Script = std::vector<std::size_t>;

  std::string choices_for(std::string_view table) const;
  Noted& place_of(const Key& key);

  /// Whether numbers get other values than usual.
  bool others_;
  /// Scripts not yet tried.
  std::deque<Script> scripts_{Script{}};
  /// Pairs of question and answer that are tried or scheduled.
  std::set<std::string> tried_;
  /// Script of the present reading; all its answers so far.
  Script script_, taken_;
  /// Choices of the present reading.
  std::vector<Choice> choices_;
  /// Keys whose presence the present reading has tested.
  std::set<std::string> asked_for_;
  /// All values of each choice.
  std::map<std::string, std::vector<std::string>> values_of_;
  /// Values with which a reading came to its end, by choice.
  std::map<std::string, std::set<std::string>> ended_;
  /// Keys noted so far.
  std::vector<Noted> noted_;
};

}  // namespace soilweave
