// Reinforced soil in a periodic cell, from a run's series.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/reinforced.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "analysis/tables/bag.h"
#include "core/error.h"
#include "core/text/settings.h"
#include "dem/loading/path.h"

namespace soilweave::analysis {
namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

using Values = std::vector<double>;

bool at_zero(const io::Series& run, std::size_t row) {
  return std::ranges::all_of(std::array{"strain_xx", "strain_yy", "strain_zz"},
                             [&](const char* name) { return run.at(name).values[row] == 0; });
}

/// Returns a strain of the cell in every row, counted from strain_origin(). A row where strains restart has the same
/// state as the row before it.
Values since_origin(const io::Series& run, const char* name) {
  Values total = run.at(name).values;
  double passed = 0;
  for (std::size_t i = 1; i < total.size(); ++i) {
    if (at_zero(run, i)) passed = total[i - 1];
    total[i] += passed;
  }
  const double origin = total[strain_origin(run)];
  for (double& strain : total) strain -= origin;
  return total;
}

/// Returns the strain along z at the first break. It is the strain of the row before plus the stage's rate times the
/// time since, at most the strain of the row after. Without a rate it is interpolated in time.
double first_break_strain(const io::Series& run, const ReinforcedCell& cell, const Values& strain) {
  const Values &time = run.at("time").values, &stage = run.at("stage").values;
  if (!cell.first_break || time.size() < 2 || *cell.first_break < time.front()) return absent;
  std::size_t after = 1;
  while (after + 1 < time.size() && time[after] < *cell.first_break) ++after;
  const double elapsed = *cell.first_break - time[after - 1], whole = strain[after] - strain[after - 1];
  const auto number = static_cast<std::size_t>(stage[after]);
  const std::optional<double> rate =
      number < cell.loading_rate.size() ? cell.loading_rate[number] : std::optional<double>();
  const double share = elapsed / (time[after] - time[after - 1]);
  const double strained = rate ? *rate * elapsed : std::abs(whole) * std::min(share, 1.0);
  return strain[after - 1] + std::copysign(std::min(strained, std::abs(whole)), whole);
}

class ReinforcedTable {
 public:
  ReinforcedTable(const io::Series& run, const ReinforcedCell& cell)
      : run_(run), cell_(cell), origin_(strain_origin(run)) {}

  io::Series table() {
    for (const char* name : {"step", "time", "stage"}) copy(name);
    put_strains();
    put_stress("", "stress", "the cell, everything in it");
    put("stress_ratio", "1", "axial over lateral stress of the cell", [this](std::size_t i) {
      const double lateral = done("lateral_stress")[i];
      return lateral != 0 ? done("axial_stress")[i] / lateral : absent;
    });
    copy("void_ratio");
    put_stress("yarn_", "yarn_stress", "the yarns, their part of the cell's");
    put_soil();
    put_fill();
    put_yarns();
    for (const char* name : {"kinetic_energy", "unbalanced_force", "boundary_work", "energy_error"}) copy(name);
    return std::move(table_);
  }

 private:
  const Values& of(const std::string& name) const { return run_.at(name).values; }
  const Values& done(const char* name) const { return table_.at(name).values; }
  void put(const std::string& name, const char* unit, const std::string& long_name,
           const std::function<double(std::size_t)>& value) {
    io::Column column{name, unit, long_name, {}};
    for (std::size_t i = 0; i < run_.rows(); ++i) column.values.push_back(value(i));
    table_.columns.push_back(std::move(column));
  }
  void copy(const std::string& name) { table_.columns.push_back(run_.at(name)); }

  /// Appends axial and lateral stress from the tensor `source` of the series.
  void put_stress(const std::string& prefix, const std::string& source, const std::string& whose) {
    const Values &x = of(source + "_xx"), &y = of(source + "_yy"), &z = of(source + "_zz");
    put(prefix + "axial_stress", "Pa", "vertical stress of " + whose, [&](std::size_t i) { return z[i]; });
    put(prefix + "lateral_stress", "Pa", "mean horizontal stress of " + whose,
        [&](std::size_t i) { return 0.5 * (x[i] + y[i]); });
  }

  void put_strains() {
    const Values axial = since_origin(run_, "strain_zz"), x = since_origin(run_, "strain_xx"),
                 y = since_origin(run_, "strain_yy");
    put("strain_axial", "1", "natural strain of the cell along z", [&](std::size_t i) { return axial[i]; });
    put("strain_axial_engineering", "1", "lost share of the cell's height",
        [&](std::size_t i) { return -std::expm1(-axial[i]); });
    put("strain_x", "1", "natural strain of the cell along x", [&](std::size_t i) { return x[i]; });
    put("strain_y", "1", "natural strain of the cell along y", [&](std::size_t i) { return y[i]; });
    put("strain_volumetric", "1", "sum of the cell's natural strains, contraction positive",
        [&](std::size_t i) { return axial[i] + x[i] + y[i]; });
  }

  void put_soil() {
    put_stress("soil_", "soil_stress", "the reinforced soil");
    for (const char* name : {"soil_mean_stress", "soil_deviatoric_stress", "soil_obliquity", "soil_void_ratio",
                             "soil_delaunay_void_ratio"})
      copy(name);
    const Values& e = of("soil_delaunay_void_ratio");
    put("soil_strain_volumetric", "1", "natural strain of the soil's Delaunay volume, contraction positive",
        [&](std::size_t i) { return std::log((1 + e[origin_]) / (1 + e[i])); });
    put("soil_strain_deviatoric", "1", "axial strain of the cell less a third of the soil's volumetric one",
        [this](std::size_t i) { return done("strain_axial")[i] - done("soil_strain_volumetric")[i] / 3; });
    copy("soil_coordination_number");
    for (const char* name : {"face_friction_x", "face_friction_y", "face_friction_z"}) copy(name);
    for (const io::Column& column : run_.columns)
      if (column.name.starts_with("group_")) table_.columns.push_back(column);
  }

  void put_fill() {
    if (!run_.find("fill_stress_xx")) return;
    put_stress("fill_", "fill_stress", "the fill");
    copy("fill_void_ratio"), copy("fill_coordination_number");
  }

  void put_yarns() {
    for (const char* family : {"face", "side_horizontal", "side_vertical"}) copy(std::string("yarn_tension_") + family);
    copy("broken_yarns");
    const double strain = first_break_strain(run_, cell_, done("strain_axial"));
    put("first_break_strain", "1", "axial strain at which the first yarn broke, the same in all rows",
        [&](std::size_t) { return strain; });
  }

  const io::Series& run_;
  const ReinforcedCell& cell_;
  std::size_t origin_;
  io::Series table_;
};

}  // namespace

ReinforcedCell reinforced_cell(const io::RunFile& run, const std::string& where) {
  if (run.series.rows() == 0)
    throw DataError(where + ": has no series: it is a packing, not a run; load it by run-dem");
  const io::Snapshot& start = run.snapshots.front();
  if (!is_reinforced(start))
    throw DataError(where + ": has neither a geotextile nor soil within fill; surround a bag by filter-expand first");
  for (int a = 0; a < 3; ++a)
    if (!start.cell.periodic[static_cast<std::size_t>(a)])
      throw DataError(
          fmt::format("{}: its cell is open along {}, and strains and stresses of a cell need a periodic "
                      "one; a bag between plates has the table loading",
                      where, "xyz"[a]));
  ReinforcedCell cell;
  Settings scenario = Settings::parse(run.scenario, where + ": scenario");
  for (Settings& stage : scenario.tables("stage")) {
    const auto path = dem::read_path(stage.text("path", ""), stage);
    cell.loading_rate.emplace_back();
    if (!path || path->stations() == 0) continue;
    const dem::AxisGoal goal = path->goals(0, {3, Mat3::Zero(), Vec3::Zero()})[2];
    if (goal.kind == dem::AxisGoal::Kind::strain) cell.loading_rate.back() = goal.max_rate;
  }
  const io::YarnsRecord& yarns = run.snapshots.back().yarns;
  for (std::size_t k = 0; k < yarns.size(); ++k)
    if (yarns.broken[k])
      cell.first_break = std::min(cell.first_break.value_or(yarns.break_time[k]), yarns.break_time[k]);
  try {
    reinforced(run.series, cell);
  } catch (const DataError& error) {
    throw DataError(fmt::format("{}: its series has {}", where, error.what()));
  }
  return cell;
}

std::size_t strain_origin(const io::Series& run) {
  for (std::size_t i = run.rows(); i-- > 0;)
    if (at_zero(run, i)) return i;
  return 0;
}

io::Series reinforced(const io::Series& run, const ReinforcedCell& cell) { return ReinforcedTable(run, cell).table(); }

}  // namespace soilweave::analysis
