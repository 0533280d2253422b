// Geotextiles by name or by their numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/geotextile.h"

#include <fmt/format.h>

#include <charconv>

#include "core/data.h"
#include "core/error.h"
#include "core/settings.h"
#include "core/text.h"
#include "io/files.h"

namespace soilweave::gws {

Geotextile Geotextile::layers(double n) const {
  return {number_text(n) + name, n * stiffness, n * strength, failure_strain};
}

std::vector<std::string> geotextile_names() { return data_names("geotextiles", ".toml"); }

Geotextile read_geotextile(const std::string& text, const std::string& where) {
  Settings document = Settings::parse(text, where);
  Geotextile found;
  found.name = document.text("name");
  found.stiffness = document.number(tensile_stiffness);
  found.strength = document.number(tensile_strength);
  found.failure_strain = document.number(failure_strain_range);
  // The yarns' curve belongs to the discrete model, so it is only checked here.
  static constexpr Parameter point{"yarn_strain", "1", 0, 1e12, true, "points of the yarns' curve"};
  for (const char* key : {"yarn_strain", "yarn_tension"})
    if (document.has(key)) document.numbers({key, point.unit, point.low, point.high, true, point.sentence});
  if (document.has("unloading_slope")) document.number({"unloading_slope", "1", 0, 1e15, true, point.sentence});
  document.finish();
  return found;
}

Geotextile find_geotextile(const std::string& name) {
  if (name.find('/') != std::string::npos || name.ends_with(".toml"))
    return read_geotextile(io::read_text(name, "geotextile").text, name);
  double layers = 1;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), layers);
  const bool counted = failure == std::errc();
  const std::string base = counted ? std::string(end, name.data() + name.size()) : name;
  const std::vector<std::string> known = geotextile_names();
  for (const std::string& one : known)
    if (one == base) {
      const auto path = data_file("geotextiles", base + ".toml");
      const Geotextile found = read_geotextile(io::read_text(path, "geotextile").text, path.string());
      if (!counted) return found;
      if (!(layers > 0 && layers <= 1e3))
        throw DataError(fmt::format("geotextile {}: {} layers; must be above 0 and at most 1000", name, layers));
      return found.layers(layers);
    }
  throw DataError(fmt::format("geotextile {}: unknown; multiples such as 3PP and paths of TOML files are taken too{}",
                              name, suggestion(base, known)));
}

}  // namespace soilweave::gws
