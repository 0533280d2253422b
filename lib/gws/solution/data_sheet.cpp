// Geotextiles by their data sheets.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/data_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace soilweave::gws {
namespace {

// Least ratio of a secant stiffness to the secant to failure. A smaller ratio means a missing unit, since no geotextile
// stiffens fiftyfold.
constexpr double least_share = 0.02;

constexpr Parameter tension_range{"tension", "N/m", 0, 1e10, true, "tension at a strain", "a stretched sheet pulls"};

std::optional<double> value(Settings& at, const Parameter& parameter) {
  if (!at.has(parameter.name)) return std::nullopt;
  return at.number(parameter);
}

Parameter named(const char* name) {
  Parameter tension = tension_range;
  tension.name = name;
  return tension;
}

DataSheet read_direction(Settings& at) {
  const std::optional<double> strength = value(at, tensile_strength);
  if (const std::string wrong = unit_mistake(std::string(tensile_strength.name), strength.value_or(0)); !wrong.empty())
    at.mistake(tensile_strength.name, wrong);
  return {value(at, named("tension_at_2")), value(at, named("tension_at_5")), strength,
          value(at, failure_strain_range)};
}

/// Returns the lower envelope of both directions: the lesser tension at each strain, the lesser strength, and the
/// greater strain at that strength. Throws DataError if a direction lacks a point or contradicts itself.
DataSheet lesser(const DataSheet& machine, const DataSheet& cross, const std::string& where) {
  const auto least = [&](const std::optional<double>& a, const std::optional<double>& b, const char* key) {
    if (a.has_value() != b.has_value())
      throw DataError(fmt::format("{}: [{}] has no {}, which [{}] has: give it, or choose a direction (NAME@{})", where,
                                  a ? "cross" : "machine", key, a ? "machine" : "cross", a ? "machine" : "cross"));
    return a ? std::optional<double>(std::min(*a, *b)) : std::nullopt;
  };
  DataSheet both{least(machine.at_2, cross.at_2, "tension_at_2"), least(machine.at_5, cross.at_5, "tension_at_5"),
                 least(machine.strength, cross.strength, "strength"),
                 least(machine.failure_strain, cross.failure_strain, "failure_strain")};
  if (!both.strength || !both.failure_strain) return both;
  const auto strain_of = [&](const DataSheet& one, const char* name) {
    return of_sheet("", one, fmt::format("{}: [{}]", where, name)).curve.strain_at(*both.strength);
  };
  both.failure_strain = std::max(strain_of(machine, "machine"), strain_of(cross, "cross"));
  return both;
}

}  // namespace

Geotextile of_sheet(const std::string& name, const DataSheet& sheet, const std::string& where) {
  if (!sheet.strength) throw DataError(where + ": no strength: give the tension at failure, as strength = \"60 kN/m\"");
  if (!sheet.failure_strain) throw DataError(where + ": no strain at failure: give it, as failure_strain = \"10 %\"");
  Geotextile found{name, 0, *sheet.strength, *sheet.failure_strain, {{0}, {0}}};
  const auto add = [&](double strain, double tension) {
    const double before = found.curve.strain.back(), held = found.curve.tension.back();
    if (strain <= before)
      throw DataError(
          fmt::format("{}: it fails at a strain of {:.4g} %, but a tension is given at {:.4g} %: check the "
                      "strain at failure, or leave that tension out",
                      where, 100 * strain, 100 * before));
    if (tension <= held)
      throw DataError(
          fmt::format("{}: {:.4g} kN/m at a strain of {:.4g} % is not above {:.4g} kN/m at {:.4g} %: check both values "
                      "and their units",
                      where, tension / 1e3, 100 * strain, held / 1e3, 100 * before));
    found.curve.strain.push_back(strain);
    found.curve.tension.push_back(tension);
  };
  if (sheet.at_2) add(0.02, *sheet.at_2);
  if (sheet.at_5) add(0.05, *sheet.at_5);
  add(*sheet.failure_strain, *sheet.strength);
  const double secant = found.strength / found.failure_strain;
  for (std::size_t k = 1; k + 1 < found.curve.strain.size(); ++k)
    if (found.curve.tension[k] / found.curve.strain[k] < least_share * secant)
      throw DataError(fmt::format(
          "{}: {:.4g} kN/m at a strain of {:.4g} % beside {:.4g} kN/m at {:.4g} %: check both units", where,
          found.curve.tension[k] / 1e3, 100 * found.curve.strain[k], found.strength / 1e3, 100 * found.failure_strain));
  found.stiffness = secant;
  return found;
}

bool is_sheet(const Settings& table) {
  const std::vector<const char*> keys{"tension_at_2", "tension_at_5", "machine", "cross"};
  return std::ranges::any_of(keys, [&](const char* key) { return table.has(key); });
}

Geotextile read_sheet(Settings& table, const std::string& direction, const std::string& where) {
  const std::string name = table.text("name");
  const bool machine = table.has("machine"), cross = table.has("cross");
  if (table.has("stiffness"))
    throw DataError(where + ": stiffness and tensions at strains both tell a stiffness: leave one of them out");
  if (!machine && !cross) {
    if (!direction.empty())
      throw DataError(fmt::format("{}: has no [{}]: leave out @{}, or write the tables [machine] and [cross]", where,
                                  direction, direction));
    return of_sheet(name, read_direction(table), where);
  }
  for (const Parameter& beside : {named("tension_at_2"), named("tension_at_5"), tensile_strength, failure_strain_range})
    if (table.has(beside.name))
      throw DataError(fmt::format(
          "{}: {} stands beside the tables of its directions: move it into [machine] and [cross]", where, beside.name));
  if (direction.empty() && machine != cross)
    throw DataError(fmt::format(
        "{}: has [{}] alone, and a bag is stretched both ways: give [{}] too, or take that one "
        "for both (NAME@{})",
        where, machine ? "machine" : "cross", machine ? "cross" : "machine", machine ? "machine" : "cross"));
  if (!(direction == "machine" ? machine : direction != "cross" || cross))
    throw DataError(fmt::format("{}: has no [{}]: write it, or leave out @{}", where, direction, direction));
  Settings along = table.table("machine"), across = table.table("cross");
  const DataSheet of_machine = read_direction(along), of_cross = read_direction(across);
  if (direction == "machine") return of_sheet(name, of_machine, where);
  if (direction == "cross") return of_sheet(name, of_cross, where);
  return of_sheet(name, lesser(of_machine, of_cross, where), where);
}

}  // namespace soilweave::gws
