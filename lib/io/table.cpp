// Tab-separated tables to and from series.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <utility>

#include "core/error.h"

namespace soilweave::io {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Removes and returns what comes before the separator, or everything.
std::string_view take(std::string_view& rest, char separator) {
  const std::size_t end = std::min(rest.find(separator), rest.size());
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return part;
}

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> found;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find('\t', at), line.size());
    found.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  return found;
}

bool number(std::string_view text, double& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return !text.empty() && error == std::errc() && end == text.data() + text.size();
}

Column headed(std::string_view cell) {
  const std::size_t bracket = cell.rfind('[');
  if (bracket == std::string_view::npos || !cell.ends_with(']')) return {std::string(cell), "", "", {}};
  return {std::string(trimmed(cell.substr(0, bracket))),
          std::string(cell.substr(bracket + 1, cell.size() - bracket - 2)),
          "",
          {}};
}

/// One line of the table; counts lines and columns for the messages.
class TableReader {
 public:
  explicit TableReader(const std::string& where) : where_(where) {}

  void line(std::string_view text) {
    ++line_;
    if (trimmed(text).empty() || text.starts_with('#')) return;
    table_.columns.empty() ? header(cells(text)) : row(cells(text));
  }
  Series finish() {
    if (table_.columns.empty()) throw DataError(where_ + ": no header line; begin with names such as \"time [s]\"");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw DataError(fmt::format("{}: line {}, column {}: {}", where_, line_, column + 1, what));
  }

  void header(const std::vector<std::string_view>& names) {
    for (std::size_t k = 0; k < names.size(); ++k) {
      double ignored = 0;
      if (number(names[k], ignored))
        fail(k, "a number where the header belongs; begin with names such as \"time [s]\"");
      Column column = headed(names[k]);
      if (column.name.empty()) fail(k, "a column without a name");
      if (table_.find(column.name)) fail(k, "a second column named " + column.name);
      table_.columns.push_back(std::move(column));
    }
  }

  void row(const std::vector<std::string_view>& values) {
    const std::size_t width = table_.columns.size();
    if (values.size() != width)
      fail(std::min(values.size(), width), fmt::format("{} values where the header names {} columns; separate them by "
                                                       "single tabs",
                                                       values.size(), width));
    for (std::size_t k = 0; k < width; ++k) {
      double value = 0;
      if (!number(values[k], value)) fail(k, fmt::format("\"{}\" is no number", values[k]));
      table_.columns[k].values.push_back(value);
    }
  }

  const std::string& where_;
  std::size_t line_ = 0;
  Series table_;
};

/// Levenshtein distance.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j)
      diagonal = std::exchange(row[j + 1], std::min({row[j] + 1, row[j + 1] + 1, diagonal + (a[i] != b[j])}));
  }
  return row.back();
}

}  // namespace

std::string exact(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

const Column* Series::find(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

const Column& Series::at(std::string_view name) const {
  if (const Column* column = find(name)) return *column;
  if (columns.empty()) throw DataError(fmt::format("no column {}: the table is empty", name));
  const auto nearest = std::min_element(columns.begin(), columns.end(), [&](const Column& a, const Column& b) {
    return distance(a.name, name) < distance(b.name, name);
  });
  throw DataError(fmt::format("no column {}; the nearest is {}", name, nearest->name));
}

std::string to_tsv(const Series& series) {
  std::string text;
  for (const Column& column : series.columns) {
    if (column.values.size() != series.rows())
      throw DataError("column " + column.name + " has another length than the first");
    text += (&column == series.columns.data() ? "" : "\t") + column.name;
    if (!column.unit.empty()) text += " [" + column.unit + "]";
  }
  text += '\n';
  for (std::size_t r = 0; r < series.rows(); ++r) {
    for (const Column& column : series.columns) {
      if (&column != series.columns.data()) text += '\t';
      text += exact(column.values[r]);
    }
    text += '\n';
  }
  return text;
}

Series from_tsv(std::string_view text, const std::string& where) {
  TableReader reader(where);
  while (!text.empty()) reader.line(take(text, '\n'));
  return reader.finish();
}

}  // namespace soilweave::io
