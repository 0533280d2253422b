// Geotextiles by name or by their numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/geotextile.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/data.h"
#include "core/error.h"
#include "core/text/settings.h"
#include "core/text/text.h"
#include "files/files.h"
#include "gws/solution/data_sheet.h"

namespace soilweave::gws {
namespace {

// Lower bounds, N/m: even nets and light nonwovens exceed 2 kN/m of stiffness and 0.5 kN/m of strength.
constexpr double least_stiffness = 2e3, least_strength = 500;

// Greatest ratio of a stiffness to the secant to failure, or of the secant to it, as in pipelines/own/fabric.py.
constexpr double greatest_ratio = 5;

double between(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin());
  if (after == x.size()) return y.back();
  if (after == 0) return y.front();
  return y[after - 1] + (y[after] - y[after - 1]) * (at - x[after - 1]) / (x[after] - x[after - 1]);
}

/// Throws DataError if the tables of a sheet's directions have other names than [machine] and [cross].
void check_directions(const Settings& document, const std::string& where) {
  for (const char* name : {"MD", "CD", "CMD", "TD", "XD", "md", "cd", "cmd", "td", "xd", "warp", "weft", "longitudinal",
                           "transverse", "Machine", "Cross"})
    if (document.has(name))
      throw DataError(fmt::format("{}: [{}] is no table of a sheet: the directions are written [machine] and [cross]",
                                  where, name));
}

/// Reads the table of a geotextile or of a product in a catalogue. The caller calls finish().
Geotextile read_table(Settings& document, const std::string& where, const std::string& direction) {
  if (is_sheet(document)) return read_sheet(document, direction, where);
  // has() marks a key as known. So check_directions() runs only where reading fails anyway.
  if (!document.has(tensile_strength.name)) check_directions(document, where);
  if (!direction.empty())
    throw DataError(fmt::format("{}: has no [{}]: leave out @{}, or write the tables [machine] and [cross]", where,
                                direction, direction));
  Geotextile found;
  found.name = document.text("name");
  found.stiffness = document.number(tensile_stiffness);
  found.strength = document.number(tensile_strength);
  found.failure_strain = document.number(failure_strain_range);
  for (const auto& [key, value] :
       {std::pair{tensile_stiffness.name, found.stiffness}, std::pair{tensile_strength.name, found.strength}})
    if (const std::string wrong = unit_mistake(std::string(key), value); !wrong.empty()) document.mistake(key, wrong);
  // The yarns' curve belongs to the discrete model, so it is only checked here.
  static constexpr Parameter point{"yarn_strain", "1", 0, 1e12, true, "points of the yarns' curve"};
  for (const char* key : {"yarn_strain", "yarn_tension"})
    if (document.has(key)) document.numbers({key, point.unit, point.low, point.high, true, point.sentence});
  if (document.has("unloading_slope")) document.number({"unloading_slope", "1", 0, 1e15, true, point.sentence});
  return found;
}

/// Throws DataError if stiffness, strength and strain at failure contradict each other.
void check_stiffness(const Geotextile& found, const std::string& where) {
  const double secant = found.strength / found.failure_strain;
  if (std::max(found.stiffness / secant, secant / found.stiffness) < greatest_ratio) return;
  throw DataError(
      fmt::format("{}: stiffness is {:.4g} kN/m, strength over failure_strain {:.4g} kN/m: they contradict each other; "
                  "correct one of the three",
                  where, found.stiffness / 1e3, secant / 1e3));
}

Geotextile of_catalogue(const std::string& path, const std::string& product, const std::string& direction) {
  Settings document = Settings::parse(io::read_text(path, "catalogue").text, path);
  std::vector<Settings> products = document.tables("product");
  std::vector<std::string> known;
  for (Settings& one : products) known.push_back(one.text("name", ""));
  if (known.empty()) document.finish();  // it names what the file holds instead
  const auto place = std::ranges::find(known, product);
  if (place == known.end())
    throw DataError(fmt::format("{}: has no [[product]] named {}{}", path, product, suggestion(product, known)));
  if (const auto count = std::ranges::count(known, product); count > 1)
    throw DataError(
        fmt::format("{}: {} of its [[product]] are named {}: give each a name of its own", path, count, product));
  for (std::size_t k = 0; k < products.size(); ++k)
    if (known[k] != product) products[k].leave();
  Settings& wanted = products[static_cast<std::size_t>(place - known.begin())];
  const std::string where = fmt::format("{}: {}", path, product);
  const Geotextile found = read_table(wanted, where, direction);
  document.finish();
  check_stiffness(found, where);
  return found;
}

/// Throws DataError if the document is a catalogue, because no product was named.
void check_no_catalogue(Settings& document, const std::string& where) {
  if (!document.has("product")) return;
  std::vector<std::string> names;
  for (Settings& table : document.tables("product")) names.push_back(table.text("name", "?"));
  throw DataError(fmt::format("{}: is a catalogue: name one of its products, as {}:{} ({})", where, where,
                              names.empty() ? "NAME" : names.front(), fmt::join(names, ", ")));
}

}  // namespace

double TensionCurve::tension_at(double at) const { return between(strain, tension, at); }
double TensionCurve::strain_at(double held) const { return between(tension, strain, held); }

Geotextile Geotextile::layers(double n) const {
  Geotextile all = *this;
  all.name = number_text(n) + name;
  all.stiffness *= n;
  all.strength *= n;
  for (double& held : all.curve.tension) held *= n;
  return all;
}

std::vector<std::string> geotextile_names() { return data_names("geotextiles", ".toml"); }

Geotextile read_geotextile(const std::string& text, const std::string& where, const std::string& direction) {
  Settings document = Settings::parse(text, where);
  check_no_catalogue(document, where);
  Geotextile found = read_table(document, where, direction);
  document.finish();
  check_stiffness(found, where);
  return found;
}

std::string unit_mistake(const std::string& name, double value) {
  const double least = name == tensile_strength.name ? least_strength : least_stiffness;
  if (value >= least || !(value > 0)) return "";
  return fmt::format("{} N/m is less than any geotextile has ({} N/m); did you mean \"{} kN/m\"?", number_text(value),
                     number_text(least), number_text(value));
}

Geotextile find_geotextile(const std::string& given) {
  const std::size_t at = given.rfind('@');
  const std::string name = given.substr(0, at), direction = at == std::string::npos ? "" : given.substr(at + 1);
  if (at != std::string::npos && direction != "machine" && direction != "cross")
    throw DataError(fmt::format("geotextile {}: '{}' is no direction: give @machine or @cross", given, direction));
  const std::size_t colon = name.find(".toml:");
  if (colon != std::string::npos) return of_catalogue(name.substr(0, colon + 5), name.substr(colon + 6), direction);
  if (name.find('/') != std::string::npos || name.ends_with(".toml"))
    return read_geotextile(io::read_text(name, "geotextile").text, name, direction);
  double layers = 1;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), layers);
  const bool counted = failure == std::errc();
  const std::string base = counted ? std::string(end, name.data() + name.size()) : name;
  const std::vector<std::string> known = geotextile_names();
  for (const std::string& one : known)
    if (one == base) {
      const auto path = data_file("geotextiles", base + ".toml");
      const Geotextile found = read_geotextile(io::read_text(path, "geotextile").text, path.string(), direction);
      if (!counted) return found;
      if (!(layers > 0 && layers <= 1e3))
        throw DataError(fmt::format("geotextile {}: {} layers; must be above 0 and at most 1000", name, layers));
      return found.layers(layers);
    }
  throw DataError(fmt::format("geotextile {}: unknown; multiples such as 3PP and paths of TOML files are taken too{}",
                              name, suggestion(base, known)));
}

}  // namespace soilweave::gws
