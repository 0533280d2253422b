// Converts tables from text to series and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/error.h"
#include "core/terminal.h"
#include "core/text/number_word.h"
#include "core/text/text.h"
#include "core/text/units.h"

namespace soilweave::io {
namespace {

/// Removes and returns what precedes the separator, or everything.
std::string_view take(std::string_view& rest, char separator) {
  const std::size_t end = std::min(rest.find(separator), rest.size());
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return part;
}

/// Returns a cell without outer blanks and quotes.
std::string unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() < 2 || !cell.starts_with('"') || !cell.ends_with('"')) return std::string(cell);
  std::string text(trimmed(cell.substr(1, cell.size() - 2)));
  for (std::size_t at = text.find("\"\""); at != std::string::npos; at = text.find("\"\"", at + 1)) text.erase(at, 1);
  return text;
}

bool is_unit(const std::string& text) {
  try {
    demand_unit(text);
    return !text.empty();
  } catch (const DataError&) {
    return false;
  }
}

/// Takes a heading apart: "p [kPa]", or as other programs write it "p (kPa)". Round brackets may also be part of a
/// name.
Column headed(const std::string& cell) {
  const std::size_t open = cell.find_last_of("[(");
  const bool square = cell.ends_with(']'), round = cell.ends_with(')');
  if (open == std::string::npos || !(square ? cell[open] == '[' : round && cell[open] == '('))
    return {cell, "", "", {}};
  const std::string unit(trimmed(std::string_view(cell).substr(open + 1, cell.size() - open - 2)));
  if (round && !is_unit(unit)) return {cell, "", "", {}};
  return {std::string(trimmed(std::string_view(cell).substr(0, open))), unit, "", {}};
}

/// Reader of table lines; it counts lines and columns for messages.
class TableReader {
 public:
  explicit TableReader(const std::string& where) : where_(where) {}

  void line(std::string_view text) {
    ++line_;
    if (trimmed(text).empty() || text.starts_with('#')) return;
    if (!table_.columns.empty()) return row(text);
    separator_ = separator_of(text);
    // Column names may contain blanks, so a header without a separator names one column.
    header(separator_ == ' ' ? std::vector<std::string>{unquoted(text)} : cells(text, separator_));
  }
  Series finish() {
    if (table_.columns.empty()) throw DataError(where_ + ": no header line; begin with names such as \"time [s]\"");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw DataError(fmt::format("{}: line {}, column {}: {}", where_, line_, column + 1, what));
  }

  void header(const std::vector<std::string>& names) {
    std::set<std::string> known;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (number_of(names[k]) || !number_remedy(names[k]).empty())
        fail(k, "a number where the header belongs; begin with names such as \"time [s]\"");
      Column column = headed(names[k]);
      if (column.name.empty()) fail(k, "a column without a name");
      if (separator_ == ' ' && column.name.find(']') != std::string::npos)
        fail(k, "names separated by blanks; separate columns by tabs, commas or semicolons");
      if (!known.insert(column.name).second) fail(k, "a second column named " + column.name);
      table_.columns.push_back(std::move(column));
    }
  }

  /// Returns the message for a line whose number of values differs from the header's.
  std::string other_width(std::size_t values, std::string_view text) const {
    const std::size_t width = table_.columns.size();
    std::string why = fmt::format("{} values where the header names {} columns", values, width);
    if (separator_ == ' ') return why + "; separate columns by tabs, commas or semicolons, the header too";
    why += fmt::format(", separated by {}", separator_name(separator_));
    if (separator_ == ',' && values > width) return why + "; with decimal commas among them? write decimal points";
    if (const char other = separator_of(text); other != separator_ && values == 1)
      return why + fmt::format("; this line has {}: use one separator throughout", separator_name(other));
    return why + (separator_ == '\t' ? "; separate them by single tabs" : "");
  }

  void row(std::string_view text) {
    const std::vector<std::string> values =
        separator_ == ' ' ? std::vector<std::string>{unquoted(text)} : cells(text, separator_);
    const std::size_t width = table_.columns.size();
    const bool one_of_many = separator_ == ' ' && separator_of(text) != ' ' && number_remedy(values[0]).empty();
    if (values.size() != width || one_of_many)
      fail(std::min(values.size(), width),
           other_width(one_of_many ? cells(text, separator_of(text)).size() : values.size(), text));
    for (std::size_t k = 0; k < width; ++k) {
      if (values[k].empty())
        fail(k, fmt::format("no value of {}; fill the cell in, or leave the line out", table_.columns[k].name));
      const std::optional<double> value = number_of(values[k]);
      if (!value)
        fail(k, no_number(values[k]) + (separator_ == ' ' && values[k].find(' ') != std::string::npos
                                            ? "; separate columns by tabs, commas or semicolons"
                                            : ""));
      table_.columns[k].values.push_back(*value);
    }
  }

  const std::string& where_;
  std::size_t line_ = 0;
  char separator_ = '\t';
  Series table_;
};

}  // namespace

std::string exact(double value) {
  if (std::isnan(value)) return "nan";  // its sign depends on the processor
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
  std::vector<std::string> names;
  for (const Column& column : columns) names.push_back(column.name);
  const std::string near = nearest(name, names);
  throw DataError(fmt::format("no column {} among {}{}", name, column_names(*this),
                              near.empty() ? "" : fmt::format("; did you mean {}?", near)));
}

std::vector<std::string> columns_like(const Series& table, std::string_view name) {
  std::vector<std::string> found;
  for (const Column& column : table.columns)
    if (column.name != name && lower_case(column.name).find(name) != std::string::npos) found.push_back(column.name);
  return found;
}

void demand_one(const Series& table, std::string_view name, const std::string& where) {
  if (const std::vector<std::string> others = columns_like(table, name); !others.empty())
    throw DataError(
        fmt::format("{}: its columns {} and {} could both be meant: leave one of them out, and head the other {}",
                    where, name, others.front(), name));
}

std::string column_names(const Series& table) {
  constexpr std::size_t most = 30;
  std::string names;
  for (std::size_t k = 0; k < std::min(most, table.columns.size()); ++k)
    names += (k > 0 ? ", " : "") + table.columns[k].name;
  if (table.columns.size() > most) names += fmt::format(" and {} more", table.columns.size() - most);
  return names;
}

std::vector<double> in_unit(const Series& table, std::string_view name, std::string_view unit,
                            const std::string& where) {
  try {
    const Column& column = table.at(name);
    if (column.unit.empty() && unit != "1")
      throw DataError(fmt::format("has no unit: write it in the header, such as {} [{}]", name, unit));
    const double factor = unit_factor(column.unit.empty() ? unit : std::string_view(column.unit), unit);
    std::vector<double> values = column.values;
    for (double& v : values) v *= factor;
    return values;
  } catch (const DataError& error) {
    const std::string column = table.find(name) ? fmt::format("column {}: ", name) : "";
    throw DataError(fmt::format("{}: {}{}", where, column, error.what()));
  }
}

std::vector<std::string> cells(std::string_view line, char separator) {
  std::vector<std::string> found;
  bool quoted = false, begun = false;
  std::size_t start = 0;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"') quoted = !quoted;
    const bool ends = !quoted && (line[at] == separator || (separator == ' ' && line[at] == '\t'));
    if (!ends) {
      begun = true;
      continue;
    }
    if (separator != ' ' || begun) found.push_back(unquoted(line.substr(start, at - start)));
    begun = false;
    start = at + 1;
  }
  if (separator != ' ' || begun) found.push_back(unquoted(line.substr(start)));
  return found;
}

char separator_of(std::string_view header) {
  bool quoted = false;
  std::string marks;
  for (const char c : header) {
    quoted = quoted != (c == '"');
    if (!quoted) marks += c;
  }
  for (const char separator : {'\t', ';', ','})
    if (marks.find(separator) != std::string::npos) return separator;
  return ' ';
}

std::string_view separator_name(char separator) {
  return separator == '\t' ? "tabs" : separator == ';' ? "semicolons" : separator == ',' ? "commas" : "blanks";
}

std::string to_tsv(const Series& series) {
  std::string text;
  for (const Column& column : series.columns) {
    if (column.values.size() != series.rows())
      throw DataError("column " + column.name + " has another length than the first");
    text += (&column == series.columns.data() ? "" : "\t") + printable(column.name);
    if (!column.unit.empty()) text += " [" + printable(column.unit) + "]";
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
