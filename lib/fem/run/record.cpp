// Records an output of a two-scale run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/record.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace soilweave::fem {
namespace {

// A row, filled column by column. The first row makes the columns.
class Row {
 public:
  explicit Row(io::Series& table) : table_(table), first_(table.columns.empty() || table.rows() == 0) {}
  void add(const std::string& name, const std::string& unit, const std::string& meaning, double value) {
    if (at_ == table_.columns.size()) table_.columns.push_back({name, unit, meaning, {}});
    table_.columns[at_++].values.push_back(value);
  }
  void when(const Model& model) {
    add("step", "1", "number of time steps taken", static_cast<double>(model.steps()));
    add("time", "s", "time", model.time());
  }
  // Writes a symmetric tensor, tension positive, as compression positive.
  void compression(const std::string& name, const std::string& unit, const std::string& meaning, const Mat2& t) {
    add(name + "_xx", unit, meaning + ", xx", -t(0, 0));
    add(name + "_yy", unit, meaning + ", yy", -t(1, 1));
    add(name + "_xy", unit, meaning + ", xy", -0.5 * (t(0, 1) + t(1, 0)));
  }

 private:
  io::Series& table_;
  bool first_;
  std::size_t at_ = 0;
};

io::Series& table(io::MultiscaleFile& file, const std::string& name, const std::string& meaning) {
  for (auto& group : file.groups)
    if (group.name == name) return group.table;
  file.groups.push_back({name, meaning, {}});
  return file.groups.back().table;
}

double half_difference(const Mat2& t) {
  return std::sqrt(0.25 * (t(0, 0) - t(1, 1)) * (t(0, 0) - t(1, 1)) + 0.25 * (t(0, 1) + t(1, 0)) * (t(0, 1) + t(1, 0)));
}

std::vector<Mat2> stresses(const Model& model) {
  std::vector<Mat2> all;
  for (const auto& point : model.points()) all.push_back(point->stress());
  return all;
}

void elements(const Model& model, io::MultiscaleFile& file) {
  const Mesh& mesh = model.soil().mesh();
  io::Series& t = table(file, "elements", "nodes of every element, corners first");
  if (t.rows() > 0) return;
  for (Index e = 0; e < mesh.elements.size(); ++e) {
    Row row(t);
    row.add("element", "1", "number of the element", static_cast<double>(e));
    for (Index k = 0; k < mesh.nodes_of_element(); ++k)
      row.add(fmt::format("node_{}", k), "1", "number of a node", static_cast<double>(mesh.elements[e][k]));
  }
}

void nodes(const Model& model, io::MultiscaleFile& file) {
  const Soil& soil = model.soil();
  io::Series& t = table(file, "nodes", "nodes of the soil, one row a node and output");
  const std::vector<Mat2> stress = soil.at_nodes(stresses(model));
  for (Index n = 0; n < soil.positions().size(); ++n) {
    Row row(t);
    row.when(model);
    row.add("node", "1", "number of the node", static_cast<double>(n));
    row.add("x", "m", "position", soil.positions()[n][0]);
    row.add("y", "m", "position", soil.positions()[n][1]);
    row.add("displacement_x", "m", "displacement", soil.displacements()[n][0]);
    row.add("displacement_y", "m", "displacement", soil.displacements()[n][1]);
    row.add("velocity_x", "m s-1", "velocity, half a step behind", soil.velocities()[n][0]);
    row.add("velocity_y", "m s-1", "velocity, half a step behind", soil.velocities()[n][1]);
    row.compression("stress", "Pa", "stress averaged from the points around", stress[n]);
  }
}

void points(const Model& model, io::MultiscaleFile& file) {
  const Soil& soil = model.soil();
  io::Series& t = table(file, "points", "points of integration, one row a point and output");
  for (Index p = 0; p < soil.points(); ++p) {
    const SoilPoint at = soil.soil_point(p);
    const Mat2 stress = model.points()[p]->stress(), &strain = soil.strains()[p];
    const Local local = model.points()[p]->local();
    Row row(t);
    row.when(model);
    row.add("point", "1", "number of the point", static_cast<double>(p));
    row.add("element", "1", "element of the point", static_cast<double>(at.element));
    row.add("x", "m", "position of the point", at.position[0]);
    row.add("y", "m", "position of the point", at.position[1]);
    row.compression("stress", "Pa", "stress", stress);
    row.add("mean_stress", "Pa", "half the trace of the stress, p", -0.5 * stress.trace());
    row.add("deviatoric_stress", "Pa", "half the principal difference, q", half_difference(stress));
    row.compression("strain", "1", "sum of the symmetric displacement gradients", strain);
    row.add("strain_volumetric", "1", "volumetric strain", -strain.trace());
    row.add("strain_shear", "1", "sqrt(2 e:e) of the deviator in the plane", 2 * half_difference(strain));
    row.add("strain_rotation", "rad", "rotation of the soil, counter-clockwise positive",
            0.5 * (strain(1, 0) - strain(0, 1)));
    row.add("void_ratio", "1", "void ratio in the plane", local.void_ratio);
    row.add("anisotropy", "1", "anisotropy of the contact normals, F_a; -1 without contacts", local.anisotropy);
    row.add("rotation", "rad", "mean rotation of the disks since the start, counter-clockwise positive",
            local.rotation);
    row.add("contacts", "1", "number of contacts", local.contacts);
  }
}

void bars(const Model& model, io::MultiscaleFile& file) {
  if (!model.bars()) return;
  const Bars& bars = *model.bars();
  io::Series& t = table(file, "bars", "bars of the geosynthetic, one row a bar and output");
  for (Index b = 0; b < bars.bars(); ++b) {
    const Vec2 contact = bars.contact_of(b);
    Row row(t);
    row.when(model);
    row.add("bar", "1", "number of the bar", static_cast<double>(b));
    row.add("x_0", "m", "first node of the bar", bars.nodes()[b][0]);
    row.add("y_0", "m", "first node of the bar", bars.nodes()[b][1]);
    row.add("x_1", "m", "second node of the bar", bars.nodes()[b + 1][0]);
    row.add("y_1", "m", "second node of the bar", bars.nodes()[b + 1][1]);
    row.add("tension", "N m-1", "tension", bars.tension(b));
    row.add("tension_ratio", "1", "tension over strength", bars.tension(b) / bars.setup().strength);
    row.add("normal_force", "N m-1", "normal force with the soil's boundary, compression positive", contact[0]);
    row.add("shear_force", "N m-1", "shear force on the bar along the chain", contact[1]);
    row.add("broken", "1", "1 where it broke", bars.broken(b));
  }
}

// Writes the resultant of the nodal stresses on the soil over each boundary, N/m, and its length, m.
void boundaries(const Model& model, Row& row) {
  const Soil& soil = model.soil();
  const std::vector<Mat2> stress = soil.at_nodes(stresses(model));
  for (const auto& [name, boundary] : soil.mesh().boundaries) {
    if (boundary.ends.empty()) continue;
    Vec2 force = Vec2::Zero();
    double length = 0;
    for (const auto& [first, second] : boundary.ends) {
      const Vec2 edge = soil.positions()[second] - soil.positions()[first];
      force += 0.5 * (stress[first] + stress[second]) * Vec2(edge[1], -edge[0]);
      length += edge.norm();
    }
    const Vec2 reaction = soil.reaction(name);
    row.add("force_x_" + name, "N m-1", "resultant of the stresses on " + name, force[0]);
    row.add("force_y_" + name, "N m-1", "resultant of the stresses on " + name, force[1]);
    row.add("reaction_x_" + name, "N m-1", "sum of the internal forces of its nodes", reaction[0]);
    row.add("reaction_y_" + name, "N m-1", "sum of the internal forces of its nodes", reaction[1]);
    row.add("length_" + name, "m", "length of " + name, length);
  }
}

void chain(const Bars& bars, Row& row) {
  double greatest = 0;
  for (Index b = 0; b < bars.bars(); ++b) greatest = std::max(greatest, bars.tension(b));
  const Vec2 contact = bars.contact_sum(), start = bars.end_force(false), end = bars.end_force(true);
  row.add("pull_start", "m", "way of the chain's first node",
          (bars.nodes().front() - bars.setup().chain.front()).norm());
  row.add("pull_end", "m", "way of the chain's last node", (bars.nodes().back() - bars.setup().chain.back()).norm());
  row.add("force_x_start", "N m-1", "force that drives the chain's first node", start[0]);
  row.add("force_y_start", "N m-1", "force that drives the chain's first node", start[1]);
  row.add("force_x_end", "N m-1", "force that drives the chain's last node", end[0]);
  row.add("force_y_end", "N m-1", "force that drives the chain's last node", end[1]);
  row.add("interface_normal", "N m-1", "normal force between soil and chain", contact[0]);
  row.add("interface_shear", "N m-1", "shear force of the soil on the chain, along it", contact[1]);
  row.add("tension", "N m-1", "greatest tension", greatest);
  row.add("tension_ratio", "1", "greatest tension over strength", greatest / bars.setup().strength);
  row.add("broken_bars", "1", "number of broken bars", static_cast<double>(bars.broken_bars()));
}

void series(const Model& model, io::MultiscaleFile& file) {
  Row row(file.series);
  row.when(model);
  const Balance balance = model.balance();
  double error = balance.error();
  row.add("external_work", "J m-1", "work done by supports, tractions and the ends of the chain", balance.external);
  row.add("kinetic_energy", "J m-1", "kinetic energy of soil, grains and chain", balance.kinetic);
  row.add("soil_kinetic_energy", "J m-1", "kinetic energy of the finite elements", model.soil().kinetic_energy());
  row.add("stored_energy", "J m-1", "elastic energy stored since the start", balance.stored);
  row.add("dissipated_energy", "J m-1", "energy dissipated by friction, damping and breakage", balance.dissipated);
  row.add("energy_error", "J m-1", "remainder of the energy balance", error);
  boundaries(model, row);
  if (model.bars()) chain(*model.bars(), row);
}

void grains(const Model& model, const std::vector<Index>& recorded, io::MultiscaleFile& file) {
  for (const Index p : recorded) {
    if (p >= model.points().size())
      throw DataError(fmt::format("record.points names point {}, the last is {}", p, model.points().size() - 1));
    std::optional<io::Snapshot> state = model.points()[p]->packing();
    if (!state) continue;
    Row row(table(file, "recorded", "point of integration that each frame of the grains belongs to"));
    row.add("frame", "1", "number of the frame", static_cast<double>(file.frames.size()));
    row.when(model);
    row.add("point", "1", "number of the point", static_cast<double>(p));
    file.frames.push_back(std::move(*state));
  }
}

}  // namespace

void record(const Model& model, const std::vector<Index>& recorded, io::MultiscaleFile& file) {
  elements(model, file);
  nodes(model, file);
  points(model, file);
  bars(model, file);
  grains(model, recorded, file);
  series(model, file);
}

io::RunFile run_of_point(const io::MultiscaleFile& file, Index point) {
  io::RunFile run;
  run.scenario = file.scenario;
  run.source = file.source;
  const auto rows_of = [&](const io::Series& t) {
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < t.rows(); ++r)
      if (t.at("point").values[r] == static_cast<double>(point)) rows.push_back(r);
    return rows;
  };
  for (const auto& group : file.groups) {
    if (group.name == "recorded")
      for (const std::size_t r : rows_of(group.table))
        run.snapshots.push_back(file.frames.at(static_cast<std::size_t>(group.table.at("frame").values[r])));
    if (group.name != "points") continue;
    const std::vector<std::size_t> rows = rows_of(group.table);
    for (const io::Column& column : group.table.columns) {
      io::Column& taken = run.series.columns.emplace_back(io::Column{column.name, column.unit, column.long_name, {}});
      for (const std::size_t r : rows) taken.values.push_back(column.values[r]);
    }
  }
  if (run.series.rows() == 0)
    throw DataError(fmt::format("the soil has no point {}: fem-dem --table points lists all of them", point));
  if (run.snapshots.empty())
    throw DataError(fmt::format(
        "the grains of point {} were not recorded: name it in record.points, with soil.material = \"grains\"", point));
  return run;
}

}  // namespace soilweave::fem
