// Numbers, names and paragraphs as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

namespace soilweave {
namespace {

/// Returns the number of edits from a to b: insert, remove, replace, swap two neighbours (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      next[j] = std::min({row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) next[j] = std::min(next[j], before[j - 2] + 1);
    }
    before.swap(row);
    row.swap(next);
  }
  return row[b.size()];
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  // A third of the letters wrong is a typing error; more is another word.
  std::size_t best = std::min(std::max<std::size_t>(1, name.size() / 3) + 1, name.size());
  std::string found;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best) {
      best = distance;
      found = candidate;
    }
  }
  if (!found.empty()) return found;
  const auto begins = [&](const std::string& c) { return name.size() > 2 && c.starts_with(name); };
  const auto match = std::find_if(known.begin(), known.end(), begins);
  return match == known.end() ? "" : *match;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& known) {
  if (const std::string near = nearest(name, known); !near.empty()) return fmt::format("; did you mean '{}'?", near);
  if (known.empty()) return "";
  return fmt::format("; known: {}", fmt::join(known, ", "));
}

std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  const std::size_t last = text.find_last_not_of('0');
  const std::size_t zeros = last == std::string::npos ? 0 : text.size() - last - 1;
  constexpr std::size_t many = 6;
  if (zeros < many || text.find_first_of(".e") != std::string::npos) return text;
  const std::size_t lead = text.front() == '-' ? 2 : 1;
  const std::size_t exponent = text.size() - lead;
  text.resize(last + 1);
  if (text.size() > lead) text.insert(lead, 1, '.');
  return fmt::format("{}e{}", text, exponent);
}

std::string time_text(double seconds) {
  // With two significant digits, 110 would be written as 1.1e+02.
  constexpr double largest = 99.5;
  if (seconds < largest) return fmt::format("{:.2g} s", seconds);
  if (seconds < 60 * largest) return fmt::format("{:.2g} min", seconds / 60);
  return seconds < 172800 ? fmt::format("{:.3g} h", seconds / 3600) : fmt::format("{:.3g} days", seconds / 86400);
}

double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

double rounded_down(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::floor(value / unit) * unit;
}

std::string range_text(const Parameter& parameter) {
  const bool low = std::isfinite(parameter.low), high = std::isfinite(parameter.high);
  const bool pure = parameter.unit == "1" || parameter.unit.empty();
  const std::string unit = pure ? "" : fmt::format(" {}", parameter.unit);
  if (low && high)
    return fmt::format("{} {} {} {}{}", parameter.open ? "between" : "from", number_text(parameter.low),
                       parameter.open ? "and" : "to", number_text(parameter.high), unit);
  if (low) return fmt::format("{} {}{}", parameter.open ? "above" : "at least", number_text(parameter.low), unit);
  if (high) return fmt::format("{} {}{}", parameter.open ? "below" : "at most", number_text(parameter.high), unit);
  return "";
}

std::optional<std::string> range_mistake(double value, std::string_view as_given, const Parameter& parameter) {
  if (!std::isfinite(value)) return fmt::format("'{}' is not a finite number", as_given);
  if (parameter.contains(value)) return std::nullopt;
  const std::string why = parameter.why.empty() ? "" : fmt::format(" ({})", parameter.why);
  return fmt::format("{} is out of range: must be {}{}", as_given, range_text(parameter), why);
}

std::vector<std::string> wrapped(std::string_view paragraph, std::size_t width) {
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < paragraph.size();) {
    const std::size_t end = std::min(paragraph.find_first_of(" \n", at), paragraph.size());
    const std::string_view word = paragraph.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width) lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
  }
  return lines;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

}  // namespace soilweave
