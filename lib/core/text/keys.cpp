// Finds the keys of a reader by trying every answer to its questions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/text/key_recorder.h"
#include "core/text/settings.h"

namespace soilweave {
namespace {

std::string full_name(std::string_view table, std::string_view key) {
  return table.empty() ? std::string(key) : fmt::format("{}.{}", table, key);
}

// Returns all fields except `required` and `when`. Keys that differ in one of them are two keys.
auto description(const Key& k) {
  return std::tie(k.table, k.name, k.type, k.unit, k.sentence, k.low, k.high, k.open, k.words, k.standard);
}

}  // namespace

bool KeyRecorder::Choice::counts_for(std::string_view other) const {
  return governs || table.empty() || other == table || (other.starts_with(table) && other[table.size()] == '.');
}

double KeyRecorder::value(const Parameter& parameter) const {
  const bool low = std::isfinite(parameter.low), high = std::isfinite(parameter.high);
  // The second set of values depends on the key's name, so that a quotient of two values changes too.
  const double step = others_ ? 2 + 0.01 * static_cast<double>(parameter.name.size()) : 1, share = others_ ? 0.75 : 0.5;
  if (low && high) return parameter.low + std::min(step, share * (parameter.high - parameter.low));
  return low ? parameter.low + step : high ? parameter.high - step : step;
}

bool KeyRecorder::begin() {
  if (scripts_.empty()) return false;
  script_ = std::move(scripts_.front());
  scripts_.pop_front();
  taken_.clear(), choices_.clear(), asked_for_.clear();
  return true;
}

void KeyRecorder::end() {
  for (const Choice& c : choices_) ended_[c.name()].insert(c.value);
}

std::string KeyRecorder::choices_for(std::string_view table) const {
  std::string all;
  for (const Choice& c : choices_)
    if (c.counts_for(table)) all += c.name() + "=" + c.value + "\n";
  return all;
}

std::size_t KeyRecorder::decide(std::string_view table, std::string_view key, std::size_t answers) {
  const std::size_t at = taken_.size();
  const std::string question = choices_for(table) + full_name(table, key) + "?";
  for (std::size_t answer = 0; answer < answers; ++answer) {
    if (!tried_.insert(question + std::to_string(answer)).second) continue;
    if (at < script_.size() ? answer == script_[at] : answer == 0) continue;  // the present reading tries it
    Script script = taken_;
    script.push_back(answer);
    scripts_.push_back(std::move(script));
  }
  taken_.push_back(at < script_.size() ? std::min(script_[at], answers - 1) : 0);
  return taken_.back();
}

bool KeyRecorder::has(std::string_view table, std::string_view key) {
  asked_for_.insert(full_name(table, key));
  return decide(table, key, 2) == 1;
}

std::string KeyRecorder::choose(std::string_view table, std::string_view key, const std::vector<std::string>& values,
                                bool governs) {
  const std::string& value = values[decide(table, key, values.size())];
  choices_.push_back({std::string(table), std::string(key), value, governs});
  values_of_[choices_.back().name()] = values;
  return value;
}

KeyRecorder::Noted& KeyRecorder::place_of(const Key& key) {
  const auto same = [&](const Noted& n) { return description(n.key) == description(key); };
  const auto found = std::find_if(noted_.begin(), noted_.end(), same);
  if (found != noted_.end()) return *found;
  // Keys of one table stay together.
  auto place = std::find_if(noted_.rbegin(), noted_.rend(), [&](const Noted& n) { return n.key.table == key.table; });
  return *noted_.insert(place.base() == noted_.begin() ? noted_.end() : place.base(), Noted{key, 0, {}, {}});
}

void KeyRecorder::note(Key key) {
  // A default equal to the value of a choice is shown as that choice. A stage's name, for example, is its path.
  for (const Choice& c : choices_)
    if (c.table == key.table && key.standard == fmt::format("\"{}\"", c.value))
      key.standard = fmt::format("\"({})\"", c.key);
  key.required = !key.standard && !asked_for_.contains(full_name(key.table, key.name));
  Noted& n = place_of(key);
  n.key.required = n.readings == 0 ? key.required : n.key.required && key.required;
  ++n.readings;
  for (const Choice& c : choices_) {
    if (!c.counts_for(key.table) || (c.table == key.table && c.key == key.name)) continue;
    n.values[c.name()].insert(c.value);
    ++n.times[c.name()];
  }
}

std::vector<Key> KeyRecorder::keys() const {
  std::vector<Key> all;
  for (const Noted& n : noted_) {
    // A second reader of the same key gives no sentence; the described key is enough.
    const auto described = [&](const Noted& other) {
      return other.key.table == n.key.table && other.key.name == n.key.name && !other.key.sentence.empty();
    };
    if (n.key.sentence.empty() && std::any_of(noted_.begin(), noted_.end(), described)) continue;
    Key key = n.key;
    for (const auto& [choice, values] : n.values) {
      const std::vector<std::string>& every = values_of_.at(choice);
      const auto ended = ended_.find(choice);
      const bool always = ended == ended_.end() ||
                          std::includes(values.begin(), values.end(), ended->second.begin(), ended->second.end());
      if (n.times.at(choice) < n.readings || always) continue;
      std::string words;
      for (const std::string& value : every)
        if (values.contains(value)) words += (words.empty() ? "" : ", ") + value;
      const bool own = choice == full_name(key.table, choice.substr(choice.rfind('.') + 1));
      key.when.push_back(fmt::format("{} = {}", own ? choice.substr(choice.rfind('.') + 1) : choice, words));
    }
    all.push_back(std::move(key));
  }
  return all;
}

namespace {

std::vector<Key> found_by(const std::function<void(Settings&)>& read, bool others) {
  KeyRecorder recorder(others);
  while (recorder.begin()) try {
      Settings document = Settings::describing(recorder);
      read(document);
      recorder.end();
    } catch (const std::exception&) {
      // The reader refused an answer, such as the name of a missing file. The search goes on with other answers.
    }
  return recorder.keys();
}

}  // namespace

std::vector<Key> keys_of(const std::function<void(Settings&)>& read) {
  std::vector<Key> keys = found_by(read, false);
  const std::vector<Key> others = found_by(read, true);
  // A default that differs between the two searches follows from other keys.
  for (std::size_t k = 0; k < keys.size() && k < others.size(); ++k)
    if (keys[k].name == others[k].name && keys[k].standard != others[k].standard) keys[k].standard.reset();
  return keys;
}

}  // namespace soilweave
