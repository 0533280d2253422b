// The prior of the parameters.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/prior.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>

#include "core/error.h"
#include "core/text/text.h"
#include "core/text/units.h"

namespace soilweave::calibration {
namespace {

/// Returns the columns of an ensemble that are no parameters.
const std::set<std::string>& taken_names() {
  static const std::set<std::string> names = {
      "id", "step", "station", "weight", "log_importance", "effective_size", "log_evidence"};
  return names;
}

bool is_column_name(const std::string& name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

Range read_range(Settings& table, const std::set<std::string>& before) {
  Range range;
  range.name = table.text({"name", "name of the parameter: the column of the ensemble"});
  range.unit = table.text({"unit", "unit of the parameter"}, "1");
  range.long_name = table.text({"long_name", "meaning of the parameter, for axes"}, range.name);
  range.scale = table.choice({"scale", "whether values or their logarithms are drawn evenly"}, {"linear", "log"},
                             "linear") == "log"
                    ? Scale::log
                    : Scale::linear;
  try {
    demand_unit(range.unit);
  } catch (const DataError& error) {
    table.mistake("unit", error.what());
    range.unit = "1";
  }
  Parameter bound{"low", range.unit};
  bound.sentence = "lowest value";
  range.low = table.number(bound);
  bound.name = "high";
  bound.sentence = "highest value";
  range.high = table.number(bound);
  if (table.has("name")) {
    if (!is_column_name(range.name))
      table.mistake("name", fmt::format("'{}' cannot name a column; use letters, digits and _", range.name));
    else if (taken_names().contains(range.name))
      table.mistake("name", fmt::format("'{}' is a column of every ensemble; use another", range.name));
    else if (before.contains(range.name))
      table.mistake("name", fmt::format("'{}' is a parameter already", range.name));
  }
  if (table.has("low") && table.has("high")) {
    if (!(range.low < range.high))
      table.mistake("high", fmt::format("{} is not above low, {}", number_text(range.high), number_text(range.low)));
    if (range.scale == Scale::log && !(range.low > 0))
      table.mistake("low", fmt::format("{} on a log scale; must be above 0", number_text(range.low)));
  }
  return range;
}

std::string_view name_of(Scale scale) { return scale == Scale::log ? "log" : "linear"; }

// Relative difference up to which two bounds are equal, since one may be written with fewer digits.
constexpr double rounding_of_bound = 1e-9;

// Young's modulus, Pa, beyond every material; diamond has 1.2e12.
constexpr double stiffest = 5e12;

bool same_range(const Range& a, const Range& b) {
  const auto close = [](double x, double y) {
    return std::abs(x - y) <= rounding_of_bound * std::max(std::abs(x), std::abs(y));
  };
  return a.name == b.name && a.unit == b.unit && a.scale == b.scale && close(a.low, b.low) && close(a.high, b.high);
}

}  // namespace

double Range::value(double u) const {
  if (scale == Scale::linear) return low + u * (high - low);
  return low * std::pow(high / low, u);
}

double Range::coordinate(double value) const {
  if (scale == Scale::linear) return (value - low) / (high - low);
  return std::log10(value / low) / std::log10(high / low);
}

double Range::width() const { return scale == Scale::linear ? high - low : std::log10(high / low); }

std::vector<std::string> Prior::names() const {
  std::vector<std::string> list;
  for (const Range& range : ranges) list.push_back(range.name);
  return list;
}

Vector Prior::values(const Vector& coordinates) const {
  Vector row(coordinates.size());
  for (Eigen::Index k = 0; k < row.size(); ++k) row[k] = ranges[static_cast<std::size_t>(k)].value(coordinates[k]);
  return row;
}

Vector Prior::coordinates(const Vector& values) const {
  Vector row(values.size());
  for (Eigen::Index k = 0; k < row.size(); ++k) row[k] = ranges[static_cast<std::size_t>(k)].coordinate(values[k]);
  return row;
}

Prior read_prior(Settings& document) {
  Prior prior;
  std::set<std::string> names;
  for (Settings& table : document.tables("parameter")) {
    prior.ranges.push_back(read_range(table, names));
    names.insert(prior.ranges.back().name);
  }
  if (prior.ranges.empty()) document.mistake("", "no parameters; give [[parameter]] tables with name, low and high");
  return prior;
}

Prior parse_prior(std::string_view text, const std::string& where) {
  Settings document = Settings::parse(text, where);
  Prior prior = read_prior(document);
  document.finish();
  return prior;
}

std::vector<Doubt> doubts(const Prior& prior) {
  for (const Range& range : prior.ranges) {
    std::string remedy;
    if (range.unit == "deg" && range.low >= 0 && range.high <= std::numbers::pi / 2)
      remedy = fmt::format("if radians are meant, write low = {:.4g} and high = {:.4g}", range.low / degree,
                           range.high / degree);
    double pascals = 0;
    try {
      pascals = range.high * unit_factor(range.unit, "Pa");
    } catch (const DataError&) {
    }
    if (pascals > stiffest) remedy = fmt::format("no material is as stiff; if Pa are meant, give unit = \"Pa\"");
    if (!remedy.empty())
      return {{"prior_unit", fmt::format("{} lies between {:.4g} and {:.4g} {}; {}", range.name, range.low, range.high,
                                         range.unit, remedy)}};
  }
  return {};
}

bool same_ranges(const Prior& a, const Prior& b) {
  return std::is_permutation(a.ranges.begin(), a.ranges.end(), b.ranges.begin(), b.ranges.end(), same_range);
}

std::string ranges_text(const Prior& prior) {
  std::vector<std::string> parts;
  for (const Range& range : prior.ranges)
    parts.push_back(fmt::format("{} {:.4g} to {:.4g}{}, {}", range.name, range.low, range.high,
                                range.unit == "1" ? "" : " " + range.unit, name_of(range.scale)));
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::vector<Key> prior_keys() {
  return keys_of([](Settings& document) { read_prior(document); });
}

std::string prior_text(const Prior& prior) {
  std::string text;
  for (const Range& range : prior.ranges)
    text += fmt::format(
        "[[parameter]]\nname = \"{}\"\nlong_name = \"{}\"\nunit = \"{}\"\nscale = \"{}\"\nlow = {}\nhigh = {}\n\n",
        range.name, range.long_name, range.unit, name_of(range.scale), number_text(range.low), number_text(range.high));
  return text;
}

}  // namespace soilweave::calibration
