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
#include "core/text/text.h"
#include "core/text/units.h"
#include "files/exchange/table.h"

namespace soilweave::io {
namespace {

using Role = SphereRole;

struct Known {
  std::string_view name;  // lower case
  Role role;
};

constexpr std::array known_names{
    Known{"x", Role::x},          Known{"y", Role::y},           Known{"z", Role::z},
    Known{"pos_x", Role::x},      Known{"pos_y", Role::y},       Known{"pos_z", Role::z},
    Known{"posx", Role::x},       Known{"posy", Role::y},        Known{"posz", Role::z},
    Known{"xpos", Role::x},       Known{"ypos", Role::y},        Known{"zpos", Role::z},
    Known{"x_pos", Role::x},      Known{"y_pos", Role::y},       Known{"z_pos", Role::z},
    Known{"position_x", Role::x}, Known{"position_y", Role::y},  Known{"position_z", Role::z},
    Known{"center_x", Role::x},   Known{"center_y", Role::y},    Known{"center_z", Role::z},
    Known{"centre_x", Role::x},   Known{"centre_y", Role::y},    Known{"centre_z", Role::z},
    Known{"points:0", Role::x},   Known{"points:1", Role::y},    Known{"points:2", Role::z},
    Known{"points_0", Role::x},   Known{"points_1", Role::y},    Known{"points_2", Role::z},
    Known{"r", Role::radius},     Known{"rad", Role::radius},    Known{"radius", Role::radius},
    Known{"d", Role::diameter},   Known{"diam", Role::diameter}, Known{"diameter", Role::diameter},
    Known{"dia", Role::diameter}};

// Names of columns that number the grains, and of columns with the time, in lower case.
constexpr std::array<std::string_view, 12> id_names{"id",          "ids",        "body_id",  "bodyid",
                                                    "particle_id", "particleid", "grain_id", "pointid",
                                                    "point_id",    "global_id",  "globalid", "atom_id"};
constexpr std::array<std::string_view, 7> time_names{"time", "timestep",  "time_step", "step",
                                                     "iter", "iteration", "frame"};

// Words of YADE's #format line other than positions and radii. Each is one column.
constexpr std::array<std::string_view, 6> yade_words{"id", "matid", "clumpid", "mask", "mass", "material"};

struct Heading {
  std::string name;  // name as written, without the unit
  std::string unit;  // empty if none is written
  Role role = Role::other;
};

Role role_of(std::string_view name) {
  const std::string small = lower_case(name);
  const auto* found =
      std::find_if(known_names.begin(), known_names.end(), [&](const Known& k) { return k.name == small; });
  return found == known_names.end() ? Role::other : found->role;
}

template <std::size_t size>
bool is_one_of(const std::array<std::string_view, size>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), lower_case(name)) != names.end();
}

/// Takes a heading apart: "x [mm]", "x (mm)", "x_mm" and "x/mm" are x in mm.
Heading heading(const std::string& written) {
  Heading found{written, "", role_of(written)};
  const std::size_t open = written.find_last_of("[(");
  if (open != std::string::npos && (written.back() == ']' || written.back() == ')')) {
    found.name = trimmed(std::string_view(written).substr(0, open));
    found.unit = trimmed(std::string_view(written).substr(open + 1, written.size() - open - 2));
    found.role = role_of(found.name);
  } else if (const std::size_t bar = written.find_last_of("_/");
             found.role == Role::other && bar != std::string::npos) {
    const std::string unit = written.substr(bar + 1);
    if (role_of(written.substr(0, bar)) == Role::other || !is_length(unit)) return found;
    found = {written.substr(0, bar), unit, role_of(written.substr(0, bar))};
  }
  return found;
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

SphereRole column_role(const std::string& name) { return heading(name).role; }

bool is_length(std::string_view unit) {
  try {
    unit_factor(unit, "m");
    return true;
  } catch (const DataError&) {
    return false;
  }
}

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
      if (is_one_of(id_names, one.name) && !columns.id) columns.id = headings.size() - 1;
      if (is_one_of(time_names, one.name) && !columns.time) columns.time = headings.size() - 1;
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
    if (role_of(name) == Role::other && !is_one_of(yade_words, name))
      throw DataError(fmt::format(
          "the #format line has \"{}\", which is unknown: write a line of names instead, such as id x y z r, "
          "one for each column",
          name));
    at = end + 1;
  }
  return named_columns(names);
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
