// Pictures of a two-scale run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "display/display_multiscale.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/error.h"
#include "display/display_table.h"

namespace soilweave::io {
namespace {

const Series* table(const MultiscaleFile& run, const std::string& name) {
  for (const auto& group : run.groups)
    if (group.name == name) return &group.table;
  return nullptr;
}

const Series& demanded(const MultiscaleFile& run, const char* name) {
  if (const Series* found = table(run, name)) return *found;
  throw DataError(run.source.role + ": has no table \"" + name + "\": no mesh can be shown");
}

// Returns the row that a table refers to by number. Throws DataError if there is no such row.
std::size_t row_of(double number, std::size_t rows, const std::string& what) {
  if (number >= 0 && number < static_cast<double>(rows) && number == std::floor(number))
    return static_cast<std::size_t>(number);
  throw DataError(fmt::format("{} {}, and there are {}: the file is damaged", what, number, rows));
}

// Returns the elements' corner nodes, in the order of the elements.
std::vector<double> of_corners(const Series& elements, std::size_t corners) {
  std::vector<double> nodes;
  for (std::size_t e = 0; e < elements.rows(); ++e)
    for (std::size_t k = 0; k < corners; ++k) nodes.push_back(elements.at("node_" + std::to_string(k)).values[e]);
  return nodes;
}

// Returns means over the points of each element, one row per element.
Series element_means(const Series& points, const TableState& state, std::size_t elements) {
  Series means;
  const std::vector<double>& element = points.at("element").values;
  for (const Column& column : points.columns) {
    if (column.name == "step" || column.name == "time" || column.name == "point" || column.name == "x" ||
        column.name == "y")
      continue;
    Column mean{column.name, column.unit, column.long_name, std::vector<double>(elements, 0)};
    std::vector<double> number(elements, 0);
    for (const std::size_t r : state.rows) {
      const std::size_t e = row_of(element[r], elements, "a point names the element");
      mean.values[e] += column.values[r];
      ++number[e];
    }
    for (std::size_t e = 0; e < elements; ++e) mean.values[e] /= number[e];
    means.columns.push_back(std::move(mean));
  }
  return means;
}

std::vector<std::size_t> all_rows(const Series& table) {
  std::vector<std::size_t> rows(table.rows());
  for (std::size_t r = 0; r < rows.size(); ++r) rows[r] = r;
  return rows;
}

}  // namespace

std::vector<VtkPicture> show_mesh(const MultiscaleFile& run) {
  const Series &elements = demanded(run, "elements"), &nodes = demanded(run, "nodes"),
               &points = demanded(run, "points");
  const std::size_t corners = elements.find("node_3") ? 4 : 3;
  const std::vector<double> corner_nodes = of_corners(elements, corners);
  const auto states = states_of(nodes), point_states = states_of(points);
  if (states.size() != point_states.size()) throw DataError("the tables of nodes and points have other outputs");
  std::vector<VtkPicture> pictures;
  for (std::size_t k = 0; k < states.size(); ++k) {
    VtkPicture& picture = pictures.emplace_back();
    picture.time = states[k].time, picture.step = states[k].step;
    picture.shape = corners == 3 ? VtkShape::triangle : VtkShape::quad;
    picture.grid = true;
    std::vector<std::size_t> rows;
    for (const double n : corner_nodes)
      rows.push_back(states[k].rows[row_of(n, states[k].rows.size(), "an element names the node")]);
    for (const std::size_t r : rows) picture.points.emplace_back(nodes.at("x").values[r], nodes.at("y").values[r], 0);
    picture.point_data = arrays_of(nodes, rows);
    const Series means = element_means(points, point_states[k], elements.rows());
    picture.cell_data = arrays_of(means, all_rows(means));
  }
  return pictures;
}

std::vector<VtkPicture> show_bars(const MultiscaleFile& run) {
  std::vector<VtkPicture> pictures;
  const Series* bars = table(run, "bars");
  if (!bars) return pictures;
  Series values;
  for (const Column& column : bars->columns)
    if (column.name != "x_0" && column.name != "y_0" && column.name != "x_1" && column.name != "y_1")
      values.columns.push_back(column);
  for (const TableState& state : states_of(*bars)) {
    VtkPicture& picture = pictures.emplace_back();
    picture.time = state.time, picture.step = state.step;
    picture.shape = VtkShape::line;
    for (const std::size_t r : state.rows)
      for (const std::string end : {"0", "1"})
        picture.points.emplace_back(bars->at("x_" + end).values[r], bars->at("y_" + end).values[r], 0);
    picture.cell_data = arrays_of(values, state.rows);
  }
  return pictures;
}

}  // namespace soilweave::io
