// Tables of a two-scale run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "core/error.h"
#include "files/exchange/state_choice.h"

namespace soilweave::fem {
namespace {

constexpr std::string_view length_prefix = "length_";

io::Series rows_of(const io::Series& table, const std::vector<std::size_t>& rows) {
  io::Series some;
  for (const io::Column& column : table.columns) {
    io::Column& taken = some.columns.emplace_back(io::Column{column.name, column.unit, column.long_name, {}});
    taken.values.reserve(rows.size());
    for (const std::size_t r : rows) taken.values.push_back(column.values[r]);
  }
  return some;
}

/// Returns the first row of every state, and the number of rows; states are contiguous.
std::vector<std::size_t> starts_of_states(const io::Series& table) {
  const std::vector<double>& step = table.at("step").values;
  std::vector<std::size_t> starts;
  for (std::size_t r = 0; r < step.size(); ++r)
    if (r == 0 || step[r] != step[r - 1]) starts.push_back(r);
  starts.push_back(step.size());
  return starts;
}

/// Returns a quotient, NaN where the denominator is 0. Adding 0 only turns a negative zero positive.
io::Column quotient(const io::Column& over, const io::Column& under, double sign, io::Column head) {
  for (std::size_t r = 0; r < over.values.size(); ++r)
    head.values.push_back(under.values[r] == 0 ? std::numeric_limits<double>::quiet_NaN()
                                               : 0.0 + sign * over.values[r] / under.values[r]);
  return head;
}

void demand_inside(const io::Series& nodes, std::size_t count, const Vec2& place) {
  std::array<double, 2> low{}, high{};
  for (int k = 0; k < 2; ++k) {
    const std::vector<double>& x = nodes.at(k == 0 ? "x" : "y").values;
    const auto [least, most] = std::minmax_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count));
    low[k] = *least, high[k] = *most;
  }
  // A place on the contour may lie outside by the rounding of its digits.
  const double slack = 1e-6 * (high[0] - low[0] + high[1] - low[1]);
  for (int k = 0; k < 2; ++k)
    if (place[k] < low[k] - slack || place[k] > high[k] + slack)
      throw UsageError(
          fmt::format("--near {},{}: lies outside of the soil, which reaches from {:.6g},{:.6g} to {:.6g},{:.6g} m",
                      place[0], place[1], low[0], low[1], high[0], high[1]));
}

}  // namespace

io::Series table(const io::MultiscaleFile& file, const std::string& name, const std::string& where) {
  if (name == "loading") return loading(file);
  if (name == "series") return file.series;
  std::string names = "loading, series";
  for (const auto& group : file.groups) {
    if (group.name == name) return group.table;
    names += ", " + group.name;
  }
  throw UsageError("--table " + name + ": " + where + " has the tables " + names);
}

io::Series loading(const io::MultiscaleFile& file) {
  const io::Series& series = file.series;
  io::Series response;
  const auto take = [&](std::string_view name) {
    if (const io::Column* column = series.find(name)) response.columns.push_back(*column);
  };
  for (const auto* name : {"step", "time", "pull_start", "pull_end"}) take(name);
  for (const io::Column& length : series.columns) {
    if (!length.name.starts_with(length_prefix)) continue;
    const std::string boundary = length.name.substr(length_prefix.size());
    for (const auto* axis : {"x_", "y_"})
      response.columns.push_back(quotient(
          series.at(fmt::format("force_{}{}", axis, boundary)), length, 1,
          {fmt::format("traction_{}{}", axis, boundary), "Pa", "mean traction on the soil on " + boundary, {}}));
  }
  if (const io::Column* normal = series.find("interface_normal"))
    response.columns.push_back(
        quotient(series.at("interface_shear"), *normal, -1,
                 {"interface_friction", "1", "shear over normal force between soil and chain", {}}));
  for (const auto* name : {"external_work", "energy_error"}) take(name);
  return response;
}

io::Series of_state(const io::Series& table, const std::string& which, const std::string& name) {
  if (!table.find("step"))
    throw UsageError(fmt::format("--state {}: the table {} has no states; leave --state out", which, name));
  const std::vector<std::size_t> starts = starts_of_states(table);
  std::vector<std::size_t> rows;
  for (const std::size_t n : io::chosen_states(which, starts.size() - 1, "the table " + name))
    for (std::size_t r = starts[n]; r < starts[n + 1]; ++r) rows.push_back(r);
  return rows_of(table, rows);
}

io::Series near(const io::MultiscaleFile& file, const std::string& name, const Vec2& place) {
  if (name != "points" && name != "nodes")
    throw UsageError(fmt::format("--near belongs to --table points or nodes, not to {}", name));
  const std::string number = name == "points" ? "point" : "node";
  const io::Series whole = table(file, name, "the run"), nodes = table(file, "nodes", "the run");
  demand_inside(nodes, starts_of_states(nodes).at(1), place);
  const io::Column &x = whole.at("x"), &y = whole.at("y"), &numbers = whole.at(number);
  double nearest = std::numeric_limits<double>::infinity(), found = 0;
  for (std::size_t r = 0; r < starts_of_states(whole).at(1); ++r) {
    const double distance = (Vec2(x.values[r], y.values[r]) - place).norm();
    // Equal distances differ by rounding.
    if (distance < nearest * (1 - 1e-9)) nearest = distance, found = numbers.values[r];
  }
  std::vector<std::size_t> rows;
  for (std::size_t r = 0; r < whole.rows(); ++r)
    if (numbers.values[r] == found) rows.push_back(r);
  return rows_of(whole, rows);
}

}  // namespace soilweave::fem
