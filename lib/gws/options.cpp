// The options that say which bag is meant.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/options.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/data.h"
#include "core/error.h"
#include "core/text.h"
#include "core/units.h"
#include "io/files.h"
#include "io/table.h"

namespace soilweave::gws {
namespace {

constexpr Parameter width_range{"width", "m", 0, 100, true, "width of the bag, B", "a bag has an extent"},
    height_range{"height", "m", 0, 100, true, "height of the bag after compaction, H", "a bag has an extent"},
    lateral_range{"lateral_stress", "Pa", 0, 1e9, false, "lateral stress outside the bag", "no soil pulls on a bag"},
    fraction_range{"strength_fraction",
                   "1",
                   0,
                   1,
                   true,
                   "of the strength where the bag fails",
                   "a hoop cannot bear more than its strength"},
    tolerance_range{"tolerance",
                    "1",
                    1e-10,
                    1e-2,
                    false,
                    "relative error of surcharge and settlement",
                    "below it rounding, above it the shape of the curve takes over"};

/// The column in SI units.
std::vector<double> in_unit(const io::Column& column, std::string_view unit) {
  const double factor = unit_factor(column.unit.empty() ? unit : std::string_view(column.unit), unit);
  std::vector<double> values = column.values;
  for (double& v : values) v *= factor;
  return values;
}

}  // namespace

void CaseOptions::declare(tool::Table& t) {
  t.option(geotextile, "geotextile", "NAME|FILE", "of data/geotextiles, a multiple (3PP), or a TOML");
  t.option(stiffness, tensile_stiffness);
  t.option(strength, tensile_strength);
  t.option(failure_strain, failure_strain_range);
  t.option(fraction, fraction_range);
  t.option(width, width_range);
  t.option(height, height_range);
  t.option(soil, "soil", "NAME|FILE", "constants: of data/soils, or a TOML");
  t.option(assignments, "set", "KEY=VALUE", "replace a constant, as near_failure_line.kappa=1.4");
  t.option(lateral, lateral_range);
  t.option(history, "lateral-history", "FILE", "TSV with surcharge [Pa], lateral_stress [Pa]");
  t.option(tolerance, tolerance_range);
}

std::vector<std::string> CaseOptions::mistakes(bool needs_geotextile) const {
  std::vector<std::string> wrong;
  if (needs_geotextile && geotextile.empty() && !(stiffness && (strength || failure_strain)))
    wrong.emplace_back("no geotextile: give --geotextile NAME, or --stiffness and one of --strength, --failure-strain");
  if (!history.empty() && lateral > 0) wrong.emplace_back("--lateral-stress and --lateral-history: give one of them");
  return wrong;
}

Geotextile CaseOptions::read_geotextile() const {
  Geotextile found;
  if (!geotextile.empty()) found = find_geotextile(geotextile);
  if (stiffness || strength || failure_strain) {
    found.stiffness = stiffness.value_or(found.stiffness);
    if (!geotextile.empty()) found.name += " (changed)";
    found.strength = strength                               ? *strength
                     : failure_strain && geotextile.empty() ? *failure_strain * found.stiffness
                                                            : found.strength;
    found.failure_strain = failure_strain       ? *failure_strain
                           : geotextile.empty() ? found.strength / found.stiffness
                                                : found.failure_strain;
  }
  if (found.name.empty()) found.name = "given by its numbers";
  return found;
}

LateralStress CaseOptions::read_lateral(std::vector<io::Source>& sources) const {
  if (history.empty()) return lateral > 0 ? LateralStress::constant(lateral) : LateralStress{};
  const io::TextFile text = io::read_text(history, "lateral history");
  sources.push_back(text.source);
  const io::Series table = io::from_tsv(text.text, history.string());
  return {in_unit(table.at("surcharge"), "Pa"), in_unit(table.at("lateral_stress"), "Pa")};
}

ReadCase CaseOptions::read() const {
  ReadCase read;
  Case& c = read.the_case;
  read.soil = find_soil(soil, assignments, read.sources, read.scenario);
  c.soil = read.soil.soil;
  c.geotextile = read_geotextile();
  c.bag = {width, height};
  c.lateral = read_lateral(read.sources);
  c.strength_fraction = fraction;
  c.tolerance = tolerance;
  c.lateral.check(c.bag);
  return read;
}

SoilFile find_soil(const std::string& name, const std::vector<std::string>& assignments,
                   std::vector<io::Source>& sources, std::string& resolved) {
  const bool file = name.find('/') != std::string::npos || name.ends_with(".toml");
  const std::vector<std::string> known = file ? std::vector<std::string>() : data_names("soils", ".toml");
  if (!file && std::find(known.begin(), known.end(), name) == known.end())
    throw DataError(
        fmt::format("soil {}: unknown{}; paths of TOML files are taken too", name, suggestion(name, known)));
  const std::filesystem::path path = file ? std::filesystem::path(name) : data_file("soils", name + ".toml");
  const io::TextFile text = io::read_text(path, "soil");
  sources.push_back(text.source);
  Settings document = Settings::parse(text.text, file ? name : "soil " + name);
  for (const std::string& assignment : assignments) document.set(assignment);
  SoilFile read = read_soil(document);
  document.finish();
  resolved = document.resolved();
  return read;
}

}  // namespace soilweave::gws
