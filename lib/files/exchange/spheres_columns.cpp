// Column names, as people and programs write them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/spheres_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "core/error.h"
#include "core/text/number_word.h"
#include "core/text/units.h"
#include "files/exchange/table.h"

namespace soilweave::io {
namespace {

enum class Role { x, y, z, radius, diameter, other };

struct Known {
  std::string_view name;  // lower case
  Role role;
};

constexpr std::array known_names{
    Known{"x", Role::x},          Known{"y", Role::y},           Known{"z", Role::z},
    Known{"pos_x", Role::x},      Known{"pos_y", Role::y},       Known{"pos_z", Role::z},
    Known{"posx", Role::x},       Known{"posy", Role::y},        Known{"posz", Role::z},
    Known{"position_x", Role::x}, Known{"position_y", Role::y},  Known{"position_z", Role::z},
    Known{"center_x", Role::x},   Known{"center_y", Role::y},    Known{"center_z", Role::z},
    Known{"centre_x", Role::x},   Known{"centre_y", Role::y},    Known{"centre_z", Role::z},
    Known{"points:0", Role::x},   Known{"points:1", Role::y},    Known{"points:2", Role::z},
    Known{"points_0", Role::x},   Known{"points_1", Role::y},    Known{"points_2", Role::z},
    Known{"r", Role::radius},     Known{"rad", Role::radius},    Known{"radius", Role::radius},
    Known{"d", Role::diameter},   Known{"diam", Role::diameter}, Known{"diameter", Role::diameter}};

// Words of YADE's #format line other than positions and radii. Each is one column.
constexpr std::array yade_words{"id", "matid", "clumpid", "mask", "mass", "material"};

// Words, in lower case, that may surround the unit of all lengths in a comment. One of the first three leads to the
// unit.
constexpr std::array unit_words{"in",  "unit",  "units",  "all",      "length",      "lengths",  "dimensions",
                                "of",  "are",   "is",     "the",      "coordinates", "position", "positions",
                                "and", "radii", "radius", "diameter", "diameters",   "sizes",    "values"};
constexpr std::size_t leading_words = 3;

struct Heading {
  std::string name;  // name as written, without the unit
  std::string unit;  // empty if none is written
  Role role = Role::other;
};

std::string lower(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

Role role_of(std::string_view name) {
  const std::string small = lower(name);
  const auto* found =
      std::find_if(known_names.begin(), known_names.end(), [&](const Known& k) { return k.name == small; });
  return found == known_names.end() ? Role::other : found->role;
}

bool is_length(const std::string& unit) {
  try {
    unit_factor(unit, "m");
    return true;
  } catch (const DataError&) {
    return false;
  }
}

/// Takes a heading apart: "x [mm]", "x (mm)" and "x_mm" are x in mm.
Heading heading(const std::string& written) {
  Heading found{written, "", role_of(written)};
  const std::size_t open = written.find_last_of("[(");
  if (open != std::string::npos && (written.back() == ']' || written.back() == ')')) {
    found.name = trimmed(std::string_view(written).substr(0, open));
    found.unit = trimmed(std::string_view(written).substr(open + 1, written.size() - open - 2));
    found.role = role_of(found.name);
  } else if (const std::size_t bar = written.rfind('_'); found.role == Role::other && bar != std::string::npos) {
    const std::string unit = written.substr(bar + 1);
    if (role_of(written.substr(0, bar)) == Role::other || !is_length(unit)) return found;
    found = {written.substr(0, bar), unit, role_of(written.substr(0, bar))};
  }
  return found;
}

template <class Words>
bool is_among(const Words& words, std::string_view word) {
  return std::find(std::begin(words), std::end(words), lower(word)) != std::end(words);
}

/// Returns the words of a comment, without the marks between them.
std::vector<std::string> words_of(std::string_view line) {
  constexpr std::string_view marks = " \t,;=()[]";
  std::vector<std::string> words;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(marks, at), line.size());
    std::string_view word = line.substr(at, end - at);
    while (word.ends_with(':') || word.ends_with('.')) word.remove_suffix(1);
    if (!word.empty()) words.emplace_back(word);
    at = end + 1;
  }
  return words;
}

/// Returns a comment without its label, such as "Columns: ". A label that names a column stays.
std::string_view without_label(std::string_view line) {
  const std::size_t colon = line.find(": ");
  if (colon == line.npos) return line;
  const std::vector<std::string> label = words_of(line.substr(0, colon));
  const bool has_name =
      std::any_of(label.begin(), label.end(), [](const std::string& word) { return role_of(word) != Role::other; });
  return has_name ? line : trimmed(line.substr(colon + 1));
}

/// Returns the unit of length that follows "in", "unit" or "units"; empty if there is none.
std::string unit_in(const std::vector<std::string>& words) {
  bool behind = false;
  for (const std::string& word : words) {
    if (behind && is_length(word)) return word;
    const bool leads = is_among(std::span(unit_words).first<leading_words>(), word);
    behind = leads || (behind && is_among(unit_words, word));
  }
  return "";
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  const std::vector<std::string> first(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size())));
  return fmt::format("{}{}", fmt::join(first, ", "), names.size() > most ? ", ..." : "");
}

/// Returns the common unit of all lengths in a header. Throws DataError if they differ.
std::string common_unit(const std::vector<Heading>& headings) {
  const Heading* first = nullptr;
  for (const Heading& one : headings) {
    if (one.role == Role::other) continue;
    if (first == nullptr) first = &one;
    if (one.unit != first->unit)
      throw DataError(fmt::format("column {} is in {}, column {} in {}: write one unit, such as [mm], behind each",
                                  first->name, first->unit.empty() ? "no unit" : first->unit, one.name,
                                  one.unit.empty() ? "no unit" : one.unit));
  }
  return first == nullptr ? "" : first->unit;
}

}  // namespace

SphereColumns plain_columns(int dimension) {
  SphereColumns columns;
  columns.width = dimension == 2 ? 3 : 4;
  columns.y = 1;
  if (dimension != 2) columns.z = 2;
  columns.size = columns.width - 1;
  return columns;
}

SphereColumns named_columns(const std::vector<std::string>& names) {
  std::vector<Heading> headings;
  std::optional<std::size_t> x, y, z, size;
  SphereColumns columns;
  columns.width = names.size();
  for (const std::string& name : names) {
    const Heading& one = headings.emplace_back(heading(name));
    if (name.empty()) throw DataError(fmt::format("column {} has no name", headings.size()));
    std::optional<std::size_t>* place = nullptr;
    if (one.role == Role::x) place = &x;
    if (one.role == Role::y) place = &y;
    if (one.role == Role::z) place = &z;
    if (one.role == Role::radius || one.role == Role::diameter) place = &size;
    if (place == nullptr) {
      columns.unused.push_back(one.name);
      continue;
    }
    if (*place)
      throw DataError(
          fmt::format("columns {} and {} say the same: leave one of them out", headings[**place].name, one.name));
    *place = headings.size() - 1;
    if (one.role == Role::diameter) columns.size_factor = 0.5;
  }
  const std::string missing = !x ? "x" : !y ? "y" : !size ? "r, radius or diameter" : "";
  if (!missing.empty()) throw DataError(fmt::format("no column {} among {}", missing, listed(names)));
  columns.x = *x, columns.y = *y, columns.z = z, columns.size = *size;
  if (const std::string unit = common_unit(headings); !unit.empty())
    columns.length_factor = unit_factor(unit, "m"), columns.has_unit = true;
  return columns;
}

std::optional<SphereColumns> yade_columns(std::string_view line) {
  while (line.starts_with('#')) line.remove_prefix(1);
  line = trimmed(line);
  if (!line.starts_with("format")) return std::nullopt;
  const std::string_view format = trimmed(line.substr(std::string_view("format").size()));
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= format.size();) {
    const std::size_t end = std::min(format.find('_', at), format.size());
    const std::string& name = names.emplace_back(format.substr(at, end - at));
    if (role_of(name) == Role::other &&
        std::find(yade_words.begin(), yade_words.end(), lower(name)) == yade_words.end())
      throw DataError(fmt::format(
          "the #format line has \"{}\", which is unknown: write a line of names instead, such as id x y z r, "
          "one for each column",
          name));
    at = end + 1;
  }
  return named_columns(names);
}

ColumnComment column_comment(std::string_view line) {
  ColumnComment comment;
  line = trimmed(line.substr(std::min(line.find_first_not_of('#'), line.size())));
  const std::vector<std::string> all = words_of(line);
  const auto names = [&](auto... roles) {
    return std::any_of(all.begin(), all.end(), [&](const std::string& word) {
      const Role role = heading(word).role;
      return ((role == roles) || ...);
    });
  };
  if (names(Role::x) && names(Role::y) && names(Role::radius, Role::diameter)) {
    const std::string_view list = without_label(line);
    try {
      comment.columns = named_columns(header_names(list, separator_of(list)));
    } catch (const DataError& error) {
      comment.unclear = error.what();
      const auto unit = std::find_if(all.begin(), all.end(), is_length);
      if (unit != all.end()) comment.unit = *unit, comment.unit_is_vague = true;
    }
  } else {
    comment.unit = unit_in(all);
    comment.unit_is_vague = !comment.unit.empty() && std::any_of(all.begin(), all.end(), [&](const std::string& word) {
      return word != comment.unit && !is_among(unit_words, word);
    });
  }
  return comment;
}

std::vector<std::string> header_names(std::string_view line, char separator) {
  std::vector<std::string> names;
  for (std::string& cell : cells(line, separator)) {
    const bool unit = cell.starts_with('[') || cell.starts_with('(');
    if (separator == ' ' && unit && !names.empty())
      names.back() += " " + cell;
    else
      names.push_back(std::move(cell));
  }
  return names;
}

}  // namespace soilweave::io
