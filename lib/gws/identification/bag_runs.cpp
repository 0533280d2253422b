// Bags in uniaxial compression between plates, read from their runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/bag_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "analysis/tables/loading.h"
#include "analysis/tables/reinforced.h"
#include "core/data.h"
#include "core/error.h"
#include "core/text/settings.h"
#include "packing/expand/loaded_bag.h"
#include "store/bytes.h"

namespace soilweave::gws {
namespace {

/// Returns the mean length at rest of the yarns on the faces of the wrapped fabric, m.
double spacing_of_yarns(const io::YarnsRecord& yarns, std::int32_t fabric) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < yarns.size(); ++k)
    if (yarns.fabric[k] == fabric && yarns.family[k] == 0) sum += yarns.rest_length[k], ++count;
  return sum / count;
}

constexpr Parameter tensions{"yarn_tension", "N", 0, 1e12, true, "tensions of a yarn at these strains"};
constexpr Parameter multiple{"multiple", "1", 0, 1e3, true, "factor on the tensions"};

/// Returns the digests of the geotextile files that the run took.
std::vector<std::string> geotextile_files(const io::RunFile& run) {
  std::vector<std::string> digests;
  for (const io::ProvenanceRecord& record : run.source.history)
    for (const io::InputRecord& input : record.inputs)
      if (input.role == "geotextile") digests.push_back(input.sha256);
  return digests;
}

Stiffness by_name(const std::string& name, double factor, std::int32_t fabric, const io::RunFile& run,
                  const std::string& where) {
  // Largest ratio of the fabric's strength in the run to that of its data sheet, either way. Meshes round the spacing.
  constexpr double farthest = 1.25;
  const Geotextile found = find_geotextile(name);
  double layers = 1;
  const char* const end = name.data() + name.size();
  const std::string base(std::from_chars(name.data(), end, layers).ptr, end);
  const std::string sheet = io::read_bytes(data_file("geotextiles", base + ".toml")), digest = io::sha256(sheet);
  if (std::ranges::count(geotextile_files(run), digest) == 0)
    throw DataError(
        fmt::format("{}: its geotextile {} is not the one of data/geotextiles any more: its file has changed "
                    "since the run; give --geotextile FILE for it",
                    where, name));
  const std::vector<double> tension = Settings::parse(sheet, "geotextile " + base).numbers(tensions);
  const double apart = spacing_of_yarns(run.snapshots.front().yarns, fabric);
  const double share = factor * layers * tension.back() / apart / found.strength;
  if (std::max(share, 1 / share) > farthest)
    throw DataError(
        fmt::format("{}: its yarns are {:.3g} mm apart, with multiple = {:.3g}, and its fabric has {:.3g} times the "
                    "strength of {}: give --geotextile FILE with the stiffness of that fabric",
                    where, 1e3 * apart, factor, share, name));
  return {found.stiffness, "of geotextile " + name};
}

Stiffness by_numbers(Settings& table, const io::YarnsRecord& yarns, std::int32_t fabric, const std::string& where) {
  static constexpr Parameter strains{"yarn_strain", "1", 0, 10, true, "strains of the curve's points"};
  const std::vector<double> strain = table.numbers(strains), tension = table.numbers(tensions);
  if (strain.empty() || tension.empty())
    throw DataError(where + ": its geotextile has no curve that tells a stiffness; give --geotextile for it");
  const double apart = spacing_of_yarns(yarns, fabric);
  return {table.number(multiple, 1.0) * tension.back() / strain.back() / apart,
          fmt::format("the secant to failure of its curve, over {:.3g} mm between yarns", 1e3 * apart)};
}

bool has_columns(const io::Series& table, const std::vector<const char*>& names) {
  return std::ranges::all_of(names, [&](const char* name) { return table.find(name) != nullptr; });
}

/// Returns the series of the rows from `first` up to the first broken yarn.
BagSeries whole_rows(const io::Series& table, std::size_t first, const std::string& where, const Stiffness& stiffness) {
  const std::vector<double>& broken = table.at("broken_yarns").values;
  std::size_t end = first;
  while (end < broken.size() && !(broken[end] > 0)) ++end;
  const bool breaks = end < broken.size();
  if (end < first + 3)
    throw DataError(
        fmt::format("{}: {} rows from the reference row up to {}; at least 3 are needed: record more of them, "
                    "by a smaller stage.increment, or let a run under way go on",
                    where, end - std::min(first, end), breaks ? "the first broken yarn" : "the end of the record"));
  io::Series rows = table;
  for (io::Column& column : rows.columns) {
    column.values.resize(end);
    column.values.erase(column.values.begin(), column.values.begin() + static_cast<std::ptrdiff_t>(first));
  }
  BagSeries series = bag_series(rows, where, stiffness.value, false, first);
  const std::size_t last = series.row.back() + 1, unloading = last - first - series.size();
  series.note = fmt::format(
      "{}: rows {} to {} of {}, up to {}{}; tensile stiffness {:.4g} kN/m, {}", where, first + 1, last, table.rows(),
      last < end ? "the greatest axial stress" : (breaks ? "the first broken yarn" : "the last"),
      unloading > 0 ? fmt::format(", less {} of unloading and reloading", unloading) : "", series.stiffness / 1e3,
      table.find("tensile_stiffness") ? "of its column" : stiffness.source);
  return series;
}

}  // namespace

bool is_loading(const io::Series& table) {
  return has_columns(table, {"settlement", "strain_axial", "strain_volumetric", "broken_yarns"});
}

bool is_reinforced(const io::Series& table) {
  return has_columns(table, {"strain_axial_engineering", "soil_strain_volumetric", "soil_mean_stress",
                             "soil_deviatoric_stress", "broken_yarns"});
}

BagSeries bag_of_loading(const io::Series& loading, const std::string& where, const Stiffness& stiffness) {
  const std::vector<double>& settlement = loading.at("settlement").values;
  const auto first = static_cast<std::size_t>(std::ranges::find(settlement, 0.0) - settlement.begin());
  return whole_rows(loading, first, where, stiffness);
}

BagSeries bag_of_reinforced(const io::Series& table, const std::string& where, const Stiffness& stiffness) {
  const std::vector<double>& strain = table.at("strain_axial_engineering").values;
  const auto last = std::ranges::find(strain.rbegin(), strain.rend(), 0.0);
  const auto first = last == strain.rend() ? 0 : static_cast<std::size_t>(strain.rend() - last) - 1;
  io::Series soil;
  const auto take = [&](const char* from, const char* to) {
    soil.columns.push_back(table.at(from));
    soil.columns.back().name = to;
  };
  take("strain_axial_engineering", "strain_axial");
  take("soil_strain_volumetric", "strain_volumetric");
  for (double& natural : soil.columns.back().values) natural = -std::expm1(-natural);
  take("soil_mean_stress", "mean_stress");
  take("soil_deviatoric_stress", "deviatoric_stress");
  take("broken_yarns", "broken_yarns");
  if (table.find("tensile_stiffness")) take("tensile_stiffness", "tensile_stiffness");
  BagSeries series = whole_rows(soil, first, where, stiffness);
  series.from_rest = false;
  series.note += "; begins under the stress of its cell: the near-failure line alone is identified from it";
  return series;
}

Stiffness stiffness_in(const io::RunFile& run, const std::string& where) {
  const io::YarnsRecord& yarns = run.snapshots.front().yarns;
  const auto wrapped = std::ranges::min_element(yarns.fabric);
  const auto number = yarns.geotextile_id[static_cast<std::size_t>(wrapped - yarns.fabric.begin())];
  Settings scenario = Settings::parse(run.scenario, where + ": scenario");
  std::vector<Settings> tables = scenario.tables("geotextile");
  if (static_cast<std::size_t>(number) >= tables.size())
    throw DataError(
        fmt::format("{}: its scenario has no [[geotextile]] number {}, which its yarns name", where, number));
  Settings& table = tables[static_cast<std::size_t>(number)];
  if (!table.has("curve")) return by_numbers(table, yarns, *wrapped, where);
  const std::string curve = table.text("curve");
  if (curve.find('/') != std::string::npos || curve.ends_with(".toml"))
    throw DataError(
        fmt::format("{}: the curve of its geotextile is that of {}, a file which is not in the run; give "
                    "--geotextile FILE with its stiffness",
                    where, curve));
  return by_name(curve, table.number(multiple, 1.0), *wrapped, run, where);
}

BagSeries bag_of_run(const io::RunFile& run, const std::string& where, const std::optional<Geotextile>& given) {
  const auto stiffness = [&] {
    return given ? Stiffness{given->stiffness, "of " + given->name + ", as given"} : stiffness_in(run, where);
  };
  const io::Snapshot& start = run.snapshots.front();
  if (start.planes.point.empty() && std::ranges::count(start.cell.periodic, false) == 0) {
    const analysis::ReinforcedCell cell = analysis::reinforced_cell(run, where);
    return bag_of_reinforced(analysis::reinforced(run.series, cell), where, stiffness());
  }
  const io::Series loading = analysis::loading(run.series, packing::loaded_bag(run, where));
  return bag_of_loading(loading, where, stiffness());
}

}  // namespace soilweave::gws
