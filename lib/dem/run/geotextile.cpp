// Geotextiles of a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/geotextile.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/data.h"
#include "core/text/beside.h"
#include "core/text/text.h"
#include "files/files.h"

namespace soilweave::dem {
namespace {

constexpr Parameter strains{
    "yarn_strain", "1",  0,
    100,           true, "strains of the curve's points, ascending, from the origin on, the last one up to 1"};
constexpr Parameter tensions{"yarn_tension", "N", 0, 1e12, true, "tensions of a yarn at these strains"};
constexpr Parameter slope{"unloading_slope", "N", 0, 1e15, true, "tension per unit of strain when unloading"};
constexpr Parameter multiple{"multiple", "1", 0, 1e3, true, "factor on the tensions"};
constexpr Parameter failure{"failure_strain", "1", 0, 10, true, "strain at which it breaks"};
constexpr Parameter stiffness{"stiffness", "N/m", 0, 1e10, true, "tensile stiffness"};
constexpr Parameter strength{"strength", "N/m", 0, 1e10, true, "tensile strength"};

// Relative difference of the curve's last strain from failure_strain that rounding leaves. Widths of yarns, m.
constexpr double apart = 0.1, narrowest = 5e-5, widest = 1;

void check(const WireCurve& curve, Settings& table) {
  if (curve.strain.empty() || curve.strain.size() != curve.tension.size())
    return table.mistake("yarn_tension", fmt::format("has {} points, yarn_strain {}: give one for each",
                                                     curve.tension.size(), curve.strain.size()));
  for (std::size_t k = 1; k < curve.strain.size(); ++k)
    if (curve.strain[k] <= curve.strain[k - 1])
      return table.mistake("yarn_strain", fmt::format("is {} after {}: give points in the order of growing strain",
                                                      curve.strain[k], curve.strain[k - 1]));
  if (curve.strain.back() > 1)
    return table.mistake("yarn_strain", fmt::format("ends at {}, more than twice the length; per cent are written "
                                                    "\"{} %\"",
                                                    curve.strain.back(), curve.strain.back()));
  for (std::size_t k = 0; k < curve.strain.size(); ++k)
    if (curve.tension[k] > curve.unloading * curve.strain[k] * (1 + 1e-12))
      return table.mistake("unloading_slope",
                           fmt::format("{} N is flatter than the curve, {} N at a strain of {}: unloading would end in "
                                       "compression; give the steepest slope at least",
                                       curve.unloading, curve.tension[k], curve.strain[k]));
}

WireCurve read_points(Settings& table) {
  WireCurve curve;
  curve.strain = table.numbers(strains);
  curve.tension = table.numbers(tensions);
  const double first = curve.strain.empty() || curve.tension.empty() ? 1 : curve.tension[0] / curve.strain[0];
  curve.unloading = table.number(slope, first);
  check(curve, table);
  return curve;
}

/// Reads the file's numbers for the analytical model. The curve does not need them, but it must not contradict them.
void compare(WireCurve& curve, Settings& document) {
  if (document.has(stiffness.name)) document.number(stiffness);
  const bool known = !curve.strain.empty() && !curve.tension.empty() && curve.strain.back() <= 1;
  if (document.has(failure.name)) {
    const double breaks = document.number(failure);
    if (known && std::abs(curve.strain.back() / breaks - 1) > apart)
      document.mistake(strains.name,
                       fmt::format("ends at {:.4g} %, where failure_strain is {:.4g} %: correct one of them",
                                   100 * curve.strain.back(), 100 * breaks));
  }
  if (document.has(strength.name)) {
    curve.strength = document.number(strength);
    const double width = known ? curve.tension.back() / curve.strength : narrowest;
    // In a yarn 1 m or 1 mm wide, tensions without a unit are likelier those of the fabric, in N/m or kN/m.
    const bool copied = !document.bare("N").empty() && std::min(std::abs(width - 1), std::abs(1e3 * width - 1)) < 0.01;
    if (!(width >= narrowest && width <= widest) || copied)
      document.mistake(tensions.name,
                       fmt::format("ends at {:.4g} N, which is the strength of a yarn {:.4g} mm wide: correct it or "
                                   "strength, or give all tensions their unit",
                                   curve.tension.back(), 1e3 * width));
  }
}

WireCurve from_file(const std::filesystem::path& path, std::vector<io::Source>& sources) {
  const io::TextFile file = io::read_text(path, "geotextile");
  sources.push_back(file.source);
  Settings document = Settings::parse(file.text, path.string());
  WireCurve curve = read_points(document);
  curve.name = document.text({"name", "name of the geotextile"}, path.stem().string());
  compare(curve, document);
  document.finish();
  return curve;
}

}  // namespace

WireCurve read_geotextile(Settings& table, const std::string& key, const NamedFiles& files,
                          std::vector<io::Source>& sources) {
  const double factor = table.number(multiple, 1.0);
  WireCurve curve;
  double layers = 1;
  if (table.has("curve")) {
    refuse_beside(table, "curve", {strains.name, tensions.name, slope.name});
    const std::string name = table.text({"curve", "file of the curve, or name of a geotextile of data/geotextiles"});
    if (name.find('/') != std::string::npos || name.ends_with(".toml")) {
      curve = from_file(files.path(key + ".curve", name), sources);
    } else {
      const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), layers);
      if (failure != std::errc()) layers = 1;
      const std::string base = failure == std::errc() ? std::string(end, name.data() + name.size()) : name;
      const std::vector<std::string> known = data_names("geotextiles", ".toml");
      if (std::find(known.begin(), known.end(), base) == known.end() || !(layers > 0)) {
        table.mistake("curve", fmt::format("\"{}\" is unknown; multiples such as 3PP and paths of TOML files are taken "
                                           "too{}",
                                           name, suggestion(base, known)));
        return {name, {1}, {1}, 1};
      }
      curve = from_file(data_file("geotextiles", base + ".toml"), sources);
    }
  } else {
    curve = read_points(table);
  }
  for (double& t : curve.tension) t *= factor * layers;
  curve.unloading *= factor * layers;
  curve.strength *= factor == 1 ? layers : 0;
  return curve;
}

}  // namespace soilweave::dem
