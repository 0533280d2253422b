// Pictures of a table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "display/display_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "core/error.h"
#include "display/display.h"
#include "files/exchange/table.h"
#include "files/files.h"

namespace soilweave::io {
namespace {

constexpr std::array<const char*, 3> prefixes = {"", "position_", "centre_"};
constexpr std::string_view axes = "xyz";

/// Returns the columns x, y, z of the positions; z is null in 2D, all are null without positions.
std::array<const Column*, 3> position_columns(const Series& table) {
  for (const std::string prefix : prefixes) {
    const Column *x = table.find(prefix + "x"), *y = table.find(prefix + "y");
    if (x && y) return {x, y, table.find(prefix + "z")};
  }
  return {};
}

/// Column name taken apart: "stress_xy" is component (0, 1) of tensor stress, "velocity_z" component (2) of vector
/// velocity.
struct Component {
  std::string base;
  int order = 0;  // 0 scalar, 1 vector, 2 tensor
  std::size_t index = 0;
};

Component parsed(const std::string& name) {
  const std::size_t underscore = name.rfind('_');
  if (underscore == std::string::npos || underscore == 0) return {name, 0, 0};
  const std::string_view suffix = std::string_view(name).substr(underscore + 1);
  if (suffix.empty() || suffix.size() > 2 || suffix.find_first_not_of(axes) != std::string_view::npos)
    return {name, 0, 0};
  const std::size_t row = axes.find(suffix[0]);
  const std::string base = name.substr(0, underscore);
  if (suffix.size() == 1) return {base, 1, row};
  return {base, 2, 3 * row + axes.find(suffix[1])};
}

/// Columns that form one array.
struct Gathered {
  int order = 0;
  std::array<const Column*, 9> parts = {};
};

/// Columns of one principal stress: its values (Pa) and the components of its direction; z is null in 2D.
struct PrincipalColumns {
  const Column* value;
  std::array<const Column*, 3> direction;
};

/// Returns the principal stresses of a table, largest first; none if columns are missing.
std::vector<PrincipalColumns> principal_columns(const Series& table) {
  std::vector<PrincipalColumns> found;
  for (const std::string number : {"1", "2", "3"}) {
    const Column* value = table.find("principal_" + number);
    if (!value) return found;
    const std::string direction = "direction_" + number;
    found.push_back({value, {table.find(direction + "x"), table.find(direction + "y"), table.find(direction + "z")}});
    if (!found.back().direction[0] || !found.back().direction[1]) return {};
  }
  return found;
}

/// Returns a vector of a row from its columns; z is 0 without a column.
Vec3 vector_of(const std::array<const Column*, 3>& columns, std::size_t row) {
  return {columns[0]->values[row], columns[1]->values[row], columns[2] ? columns[2]->values[row] : 0.0};
}

/// Returns the length of a line per stress, m/Pa, so that the greatest stress is as long as the edge of the mean
/// volume; 1 if there is no stress.
double axes_scale(const std::vector<PrincipalColumns>& stresses, const Column& volume) {
  double greatest = 0, sum = 0;
  for (const PrincipalColumns& stress : stresses)
    for (const double value : stress.value->values)
      if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
  for (const double value : volume.values) sum += value;
  const double edge =
      std::pow(sum / static_cast<double>(volume.values.size()), 1.0 / static_cast<double>(stresses.size()));
  return greatest > 0 ? edge / greatest : 1.0;
}

VtkArray array_of(const std::string& name, const Gathered& gathered, const std::vector<std::size_t>& rows) {
  const int components = gathered.order == 0 ? 1 : gathered.order == 1 ? 3 : 9;
  std::vector<double> values;
  for (const std::size_t row : rows)
    for (std::size_t k = 0; k < static_cast<std::size_t>(components); ++k) {
      const std::size_t mirrored = 3 * (k % 3) + k / 3;
      const Column* column = gathered.parts[k]     ? gathered.parts[k]
                             : gathered.order == 2 ? gathered.parts[mirrored]
                                                   : nullptr;
      values.push_back(column ? column->values[row] : 0.0);
    }
  return {name, components, std::move(values)};
}

}  // namespace

std::vector<TableState> states_of(const Series& table) {
  const Column *step = table.find("step"), *time = table.find("time");
  const Column* key = step ? step : time;
  std::vector<TableState> states;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (row == 0 || (key && key->values[row] != key->values[row - 1]))
      states.push_back({time   ? time->values[row]
                        : step ? step->values[row]
                               : 0.0,
                        step ? std::llround(step->values[row]) : 0,
                        {}});
    states.back().rows.push_back(row);
  }
  return states;
}

bool has_positions(const Series& table) { return position_columns(table)[0] != nullptr; }

std::vector<VtkArray> arrays_of(const Series& table, const std::vector<std::size_t>& rows) {
  const auto places = position_columns(table);
  std::map<std::string, Gathered> gathered;
  for (const Column& column : table.columns) {
    if (column.name == "step" || column.name == "time") continue;
    if (std::find(places.begin(), places.end(), &column) != places.end()) continue;
    Component component = parsed(column.name);
    // A single component (fabric_zz) is a scalar, not a tensor with zeros elsewhere.
    const bool partner = table.find(component.base + (component.order == 2 ? "_xx" : "_x")) &&
                         table.find(component.base + (component.order == 2 ? "_yy" : "_y"));
    if (component.order > 0 && (!partner || table.find(component.base))) component = {column.name, 0, 0};
    Gathered& entry = gathered[component.base];
    entry.order = component.order;
    entry.parts[component.index] = &column;
  }
  std::vector<VtkArray> arrays;
  for (const auto& [name, parts] : gathered) arrays.push_back(array_of(name, parts, rows));
  return arrays;
}

VtkPicture show_rows(const Series& table, const TableState& state) {
  const auto places = position_columns(table);
  if (!places[0]) throw DataError("the table has no columns x and y: its rows have no place");
  VtkPicture picture;
  picture.time = state.time;
  picture.step = state.step;
  const Column* length = table.find("length");
  const std::array<const Column*, 3> direction = {table.find("direction_x"), table.find("direction_y"),
                                                  table.find("direction_z")};
  const bool lines = length && direction[0] && direction[1];
  for (const std::size_t row : state.rows) {
    const Vec3 place = vector_of(places, row);
    const Vec3 half = lines ? Vec3(0.5 * length->values[row] * vector_of(direction, row)) : Vec3(Vec3::Zero());
    picture.points.push_back(place - half);
    if (lines) picture.points.push_back(place + half);
  }
  if (lines) picture.shape = VtkShape::line;
  (lines ? picture.cell_data : picture.point_data) = arrays_of(table, state.rows);
  add_principal(picture, table.find("stress_zz") ? 3 : 2);
  return picture;
}

std::optional<VtkPicture> show_axes(const Series& table, const TableState& state) {
  const auto places = position_columns(table);
  const std::vector<PrincipalColumns> stresses = principal_columns(table);
  const Column* volume = table.find("volume");
  if (!places[0] || stresses.empty() || !volume) return std::nullopt;
  const double scale = axes_scale(stresses, *volume);
  VtkPicture picture;
  picture.time = state.time;
  picture.step = state.step;
  picture.shape = VtkShape::line;
  std::vector<std::int32_t> number;
  std::vector<double> stress;
  for (const std::size_t row : state.rows)
    for (std::size_t k = 0; k < stresses.size(); ++k) {
      const double value = stresses[k].value->values[row];
      if (!std::isfinite(value)) continue;
      const Vec3 place = vector_of(places, row);
      const Vec3 half = 0.5 * scale * std::abs(value) * vector_of(stresses[k].direction, row);
      picture.points.push_back(place - half), picture.points.push_back(place + half);
      number.push_back(static_cast<std::int32_t>(k + 1)), stress.push_back(value);
    }
  picture.cell_data = {{"principal", 1, std::move(number)}, {"principal_stress", 1, std::move(stress)}};
  return picture;
}

namespace {

template <class Number>
const std::vector<Number>& values_of(const VtkPicture& picture, std::string_view name) {
  const auto array = std::ranges::find_if(picture.point_data, [&](const VtkArray& one) { return one.name == name; });
  return std::get<std::vector<Number>>(array->values);
}

// Throws DataError if a grain's radius differs in the table, which then belongs to another packing. `rows`: row of each
// grain, valid where `known` is true.
void demand_same_radii(const VtkPicture& grains, const Series& table, const std::vector<std::size_t>& rows,
                       const std::vector<bool>& known) {
  const Column* there = table.find("radius");
  if (!there) return;
  const auto& bodies = values_of<std::int64_t>(grains, "body_id");
  const auto& radii = values_of<double>(grains, "radius");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double radius = there->values[rows[i]];
    if (!known[i] || std::abs(radius - radii[i]) <= 1e-6 * radii[i]) continue;
    throw DataError(
        fmt::format("the table of grains is of another packing: grain {} has a radius of {:.6g} m there, and of {:.6g} "
                    "m here; make it from this file, with homogenize --grains",
                    bodies[i], radius, radii[i]));
  }
}

// Throws DataError if a grain lies elsewhere in the table, which then belongs to another run of the packing. Positions
// of files may differ by whole cells.
void demand_same_places(const Snapshot& state, const Series& table, const std::vector<std::size_t>& rows,
                        const std::vector<bool>& known) {
  const auto places = position_columns(table);
  if (!places[0]) return;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!known[i]) continue;
    const Vec3 there = vector_of(places, rows[i]), away = there - state.grains.position[i];
    const Vec3 cells = cell_index(state.cell, away, Vec3::Constant(-0.5)).cast<double>();
    if ((away - state.cell.matrix * cells).norm() <= 1e-6 * state.grains.radius[i]) continue;
    const Vec3& here = state.grains.position[i];
    throw DataError(fmt::format(
        "the table of grains is of another run: at step {} grain {} lies at ({:.6g}, {:.6g}, {:.6g}) m "
        "there, and at ({:.6g}, {:.6g}, {:.6g}) m here; make it from this file, with homogenize --grains",
        state.step, state.grains.body_id[i], there.x(), there.y(), there.z(), here.x(), here.y(), here.z()));
  }
}

}  // namespace

Series read_grain_fields(const std::filesystem::path& path) {
  for (auto& group : read_fields(path).groups)
    if (group.name == "grains") return group.table;
  throw DataError(path.string() + " has no group \"grains\" to join");
}

void join_grains(VtkPicture& grains, const Snapshot& state, const Series& table) {
  const Column* ids = table.find("body_id");
  if (!ids) throw DataError("the table of grains has no column body_id to tell them by");
  const Column* step = table.find("step");
  std::unordered_map<std::int64_t, std::size_t> row_of;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (!step || std::llround(step->values[row]) == grains.step) row_of[std::llround(ids->values[row])] = row;
  if (row_of.empty()) throw DataError("the table of grains has no row for step " + std::to_string(grains.step));

  std::vector<std::size_t> rows;
  std::vector<bool> known;
  for (const std::int64_t body : values_of<std::int64_t>(grains, "body_id")) {
    const auto found = row_of.find(body);
    known.push_back(found != row_of.end());
    rows.push_back(known.back() ? found->second : row_of.begin()->second);
  }
  if (std::ranges::count(known, true) == 0)
    throw DataError(
        "the table of grains has a row for none of these grains; make it from this file, with homogenize "
        "--grains");
  demand_same_radii(grains, table, rows, known);
  demand_same_places(state, table, rows, known);
  for (VtkArray& array : arrays_of(table, rows)) {
    if (array.name == "body_id" || array.name == "radius") continue;
    auto& values = std::get<std::vector<double>>(array.values);
    const auto components = static_cast<std::size_t>(array.components);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!known[k / components]) values[k] = std::numeric_limits<double>::quiet_NaN();
    std::erase_if(grains.point_data, [&](const VtkArray& other) { return other.name == array.name; });
    grains.point_data.push_back(std::move(array));
  }
}

std::string to_csv(const Series& table) {
  std::string text;
  for (const Column& column : table.columns) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (const Column& column : table.columns)
      text += exact(column.values[row]) + (&column == &table.columns.back() ? '\n' : ',');
  return text;
}

}  // namespace soilweave::io
