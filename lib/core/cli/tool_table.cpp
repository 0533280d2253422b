// Fills the option table of a tool.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cli/tool_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "core/error.h"
#include "core/text/text.h"
#include "core/text/units.h"

namespace soilweave::tool {
namespace {

std::string unit_metavar(const Parameter& parameter, std::string_view otherwise) {
  const bool pure = parameter.unit.empty() || parameter.unit == "1" || parameter.unit == "-";
  return std::string(pure ? otherwise : parameter.unit);
}

/// Reads a number with or without unit and checks the parameter's range. Returns the mistake, or nothing.
std::optional<std::string> read_number(const std::string& text, const Parameter& parameter, double& field) {
  try {
    const double value = quantity(text, parameter.unit);
    if (auto mistake = range_mistake(value, text, parameter)) return mistake;
    field = value;
    return std::nullopt;
  } catch (const DataError& error) {
    const std::string range = range_text(parameter);
    return fmt::format("{}; give a number{}", error.what(),
                       range.empty() ? fmt::format(" in {}", parameter.unit) : " " + range);
  }
}

template <class Integer>
std::optional<std::string> read_integer(const std::string& text, const Parameter& parameter, Integer& field) {
  Integer value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) {
    const std::string range = range_text(parameter);
    return fmt::format("'{}' is not a whole number{}", text, range.empty() ? "" : "; give one " + range);
  }
  if (auto mistake = range_mistake(static_cast<double>(value), text, parameter)) return mistake;
  field = value;
  return std::nullopt;
}

void describe(Entry& entry, const Parameter& parameter) {
  entry.range = range_text(parameter);
  entry.why = parameter.why;
}

constexpr Parameter thread_count{"threads",
                                 "1",
                                 1,
                                 1024,
                                 false,
                                 "threads to use; the result is the same with any number",
                                 "more threads than that is a slip"};

/// OMP_NUM_THREADS may hold a list, one number per nesting level; the first counts.
int default_threads() {
  const char* variable = std::getenv("OMP_NUM_THREADS");
  const int wanted = variable == nullptr ? 1 : std::atoi(variable);
  return thread_count.contains(wanted) ? wanted : 1;
}

}  // namespace

Entry& Table::Impl::add(std::string_view name, Kind kind, std::string_view sentence) {
  Entry& entry = options.emplace_back();
  std::string hyphened(name);
  std::replace(hyphened.begin(), hyphened.end(), '_', '-');
  const std::size_t comma = hyphened.find(',');
  if (comma != std::string::npos) entry.letter = hyphened.substr(comma + 1);
  hyphened.resize(std::min(comma, hyphened.size()));
  (hyphened.size() == 1 ? entry.letter : entry.name) = hyphened;
  entry.kind = kind;
  entry.sentence = sentence;
  return entry;
}

bool Table::Impl::has(std::string_view name) const {
  return std::any_of(options.begin(), options.end(), [&](const Entry& e) { return e.name == name; });
}

std::vector<std::string> Table::Impl::names() const {
  std::vector<std::string> all;
  for (const Entry& entry : options) {
    if (!entry.letter.empty()) all.push_back("-" + entry.letter);
    if (!entry.name.empty()) all.push_back("--" + entry.name);
  }
  return all;
}

Table::Table() : impl_(std::make_unique<Impl>()) {
  impl_->invocation.version = version;
  impl_->invocation.threads = default_threads();
}
Table::~Table() = default;

void Table::about(std::string name, std::string sentence, std::string description) {
  impl_->name = impl_->invocation.tool = std::move(name);
  impl_->sentence = std::move(sentence);
  impl_->description = std::move(description);
}

void Table::example(std::string command, std::string sentence) {
  impl_->examples.emplace_back(std::move(command), std::move(sentence));
}

void Table::input(std::filesystem::path& field, std::string name, std::string sentence) {
  impl_->inputs.push_back({std::move(name), std::move(sentence), true, false, [&field](auto& t) { field = t; }, {}});
}

void Table::inputs(std::vector<std::filesystem::path>& field, std::string name, std::string sentence) {
  impl_->inputs.push_back(
      {std::move(name), std::move(sentence), true, true, [&field](auto& t) { field.emplace_back(t); }, {}});
}

void Table::optional_input(std::filesystem::path& field, std::string name, std::string sentence) {
  impl_->inputs.push_back({std::move(name), std::move(sentence), false, false, [&field](auto& t) { field = t; }, {}});
}

void Table::optional_inputs(std::vector<std::filesystem::path>& field, std::string name, std::string sentence) {
  inputs(field, std::move(name), std::move(sentence));
  impl_->inputs.back().required = false;
}

void Table::output(std::filesystem::path& field, std::string sentence) {
  impl_->output = &field;
  impl_->output_required = field.empty();
  also_output(field, "output,o", sentence + ", - for standard output");
  bool& force = impl_->invocation.force;
  flag(force, "force", "overwrite an existing output file");
  for (auto entry = impl_->options.end() - 2; entry != impl_->options.end(); ++entry) entry->general = true;
  unrecorded("force");
}

void Table::also_output(std::filesystem::path& field, std::string_view name, std::string sentence) {
  option(field, name, "FILE", sentence);
  impl_->options.back().writes = true;
}

void Table::optional_output(std::filesystem::path& field, std::string sentence) {
  output(field, std::move(sentence));
  impl_->output_required = false;
}

void Table::output_folder(std::filesystem::path& field, std::string sentence) {
  output(field, std::move(sentence));
  impl_->output_is_folder = true;
}

void Table::option(double& field, const Parameter& parameter) {
  Entry& entry = impl_->add(parameter.name, Kind::value, parameter.sentence);
  entry.metavar = unit_metavar(parameter, "X");
  describe(entry, parameter);
  entry.assign = [&field, parameter](const std::string& text) { return read_number(text, parameter, field); };
  entry.value = [&field] { return std::isnan(field) ? "" : number_text(field); };
  entry.standard = entry.value();
}

void Table::option(std::optional<double>& field, const Parameter& parameter) {
  Entry& entry = impl_->add(parameter.name, Kind::value, parameter.sentence);
  entry.metavar = unit_metavar(parameter, "X");
  describe(entry, parameter);
  entry.assign = [&field, parameter](const std::string& text) {
    double value = 0;
    auto mistake = read_number(text, parameter, value);
    if (!mistake) field = value;
    return mistake;
  };
  entry.value = [&field] { return field ? number_text(*field) : ""; };
  entry.standard = entry.value();
}

void Table::option(std::int64_t& field, const Parameter& parameter) {
  Entry& entry = impl_->add(parameter.name, Kind::value, parameter.sentence);
  entry.metavar = "N";
  describe(entry, parameter);
  entry.assign = [&field, parameter](const std::string& text) { return read_integer(text, parameter, field); };
  entry.value = [&field] { return std::to_string(field); };
  entry.standard = entry.value();
}

void Table::option(std::string& field, std::string_view name, std::string_view metavar, std::string_view sentence) {
  Entry& entry = impl_->add(name, Kind::value, sentence);
  entry.metavar = metavar;
  entry.assign = [&field](const std::string& text) {
    field = text;
    return std::optional<std::string>();
  };
  entry.value = [&field] { return field; };
  entry.standard = field;
}

void Table::option(std::filesystem::path& field, std::string_view name, std::string_view metavar,
                   std::string_view sentence) {
  Entry& entry = impl_->add(name, Kind::file, sentence);
  entry.metavar = metavar;
  entry.recorded = false;
  entry.assign = [&field](const std::string& text) {
    field = text;
    return std::optional<std::string>();
  };
  entry.value = [&field] { return field.string(); };
  entry.standard = field.string();
}

void Table::option(std::vector<std::string>& field, std::string_view name, std::string_view metavar,
                   std::string_view sentence) {
  Entry& entry = impl_->add(name, Kind::list, sentence);
  entry.metavar = metavar;
  entry.assign = [&field](const std::string& text) {
    field.push_back(text);
    return std::optional<std::string>();
  };
}

void Table::choice(std::string& field, std::string_view name, std::vector<std::string> values,
                   std::string_view sentence) {
  Entry& entry = impl_->add(name, Kind::choice, sentence);
  entry.choices = std::move(values);
  entry.metavar = fmt::format("{}", fmt::join(entry.choices, "|"));
  entry.assign = [&field, &choices = entry.choices](const std::string& text) -> std::optional<std::string> {
    if (std::find(choices.begin(), choices.end(), text) == choices.end())
      return fmt::format("'{}' is not one of {}{}", text, fmt::join(choices, ", "),
                         nearest(text, choices).empty() ? "" : suggestion(text, choices));
    field = text;
    return std::nullopt;
  };
  entry.value = [&field] { return field; };
  entry.standard = field;
}

void Table::flag(bool& field, std::string_view name, std::string_view sentence) {
  Entry& entry = impl_->add(name, Kind::flag, sentence);
  entry.assign = [&field](const std::string&) {
    field = true;
    return std::optional<std::string>();
  };
  entry.value = [&field] { return std::string(field ? "yes" : ""); };
  entry.standard = entry.value();
}

void Table::unrecorded(std::string_view name) {
  for (Entry& entry : impl_->options)
    if (entry.name == name) entry.recorded = false;
}

void Table::resume(double& interval) {
  static constexpr Parameter checkpoint_every{
      "checkpoint_every", "s", 0, 1e9, false, "seconds between checkpoints; 0: none but at recorded states"};
  option(interval, checkpoint_every);
  impl_->options.back().general = true;
  unrecorded("checkpoint-every");
  flag(impl_->invocation.resume, "resume", "continue a stopped run; the result is byte-identical");
  impl_->options.back().general = true;
  unrecorded("resume");
}

void Table::keys(std::string title, std::vector<Key> (*of)()) {
  impl_->keys_title = std::move(title), impl_->keys = of;
}

std::vector<std::string> Table::Impl::informing() const {
  std::vector<std::string> all = {"--help", "--version", "--man", "--completion"};
  if (keys) all.emplace_back("--keys");
  return all;
}

void Table::instead_of_output(bool& field, std::string_view name, std::string_view sentence) {
  flag(field, name, sentence);
  unrecorded(name);
  impl_->no_output = &field;
  impl_->no_output_name = name;
}

void Table::seed() {
  static constexpr Parameter random_seed{
      "seed", "1", 0, 1.8446744073709552e19, false, "seed of the random numbers; the same seed gives the same result"};
  std::uint64_t& field = impl_->invocation.seed;
  Entry& entry = impl_->add(random_seed.name, Kind::value, random_seed.sentence);
  entry.metavar = "N";
  entry.assign = [&field](const std::string& text) -> std::optional<std::string> {
    if (read_integer(text, random_seed, field)) return fmt::format("'{}' is not a whole number from 0 to 2^64-1", text);
    return std::nullopt;
  };
  entry.value = [&field] { return std::to_string(field); };
  entry.standard = entry.value();
  entry.general = true;
}

void Table::refuse(std::vector<std::string_view> names, std::function<bool()> idle, std::string_view why) {
  impl_->idle.push_back({std::move(names), std::move(idle), why});
}

void Table::threads() {
  int& field = impl_->invocation.threads;
  Entry& entry = impl_->add(thread_count.name, Kind::value, thread_count.sentence);
  entry.metavar = "N";
  describe(entry, thread_count);
  entry.assign = [&field](const std::string& text) { return read_integer(text, thread_count, field); };
  entry.value = [&field] { return std::to_string(field); };
  entry.standard = "OMP_NUM_THREADS or 1";
  entry.general = true;
  entry.recorded = false;
}

}  // namespace soilweave::tool
