// Tables of homogenize and fabric.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "analysis/measure/fabric.h"
#include "analysis/measure/parts.h"
#include "analysis/measure/strain.h"
#include "analysis/measure/stress.h"
#include "analysis/measure/tessellation.h"
#include "core/error.h"
#include "core/text/number_word.h"
#include "core/text/text.h"

namespace soilweave::analysis {
namespace {

constexpr const char* axes = "xyz";

// Returns a tensor or a number of the cell; NaN unless the cell is periodic, because an open cell does not follow its
// grains.
template <class Value>
Value of_cell(const io::Snapshot& state, const Value& value) {
  return is_periodic(state) ? value : Value(value * no_value);
}

void put_stress(io::Series& table, const Mat3& stress, int d) {
  put(table, "stress", "Pa", "stress, compression positive", symmetric(stress), d);
  const double p = mean(stress, d), q = deviatoric_stress(stress, d);
  put(table, "mean_stress", "Pa", "mean stress p", p);
  put(table, "deviatoric_stress", "Pa", "deviatoric stress q", q);
  put(table, "stress_obliquity", "1", "q/p", p != 0 ? q / p : no_value);
}

void put_principal(io::Series& table, const Mat3& stress, int d) {
  const Principal p = principal(stress, d);
  for (int k = 0; k < d; ++k) {
    put(table, fmt::format("principal_{}", k + 1), "Pa", "principal stress, largest first", p.values[k]);
    for (int a = 0; a < d; ++a)
      put(table, fmt::format("direction_{}{}", k + 1, axes[a]), "1", "unit direction of the principal stress",
          p.directions(a, k));
  }
}

void put_strain(io::Series& table, const Mat3& strain, int d) {
  put(table, "strain", "1", "natural strain, compression positive", strain, d);
  put(table, "strain_volumetric", "1", "sum of the natural strains, contraction positive",
      volumetric_strain(strain, d));
  put(table, "strain_deviatoric", "1", "deviatoric strain", deviatoric_strain(strain, d));
}

}  // namespace

std::vector<double>& column(io::Series& table, const std::string& name, const std::string& unit,
                            const std::string& long_name) {
  for (io::Column& one : table.columns)
    if (one.name == name) return one.values;
  table.columns.push_back({name, unit, long_name, {}});
  return table.columns.back().values;
}

void put(io::Series& table, const std::string& name, const std::string& unit, const std::string& long_name,
         double value) {
  column(table, name, unit, long_name).push_back(value);
}

void put(io::Series& table, const std::string& prefix, const std::string& unit, const std::string& long_name,
         const Mat3& tensor, int dimension) {
  for (int i = 0; i < dimension; ++i)
    for (int j = i; j < dimension; ++j)
      put(table, fmt::format("{}_{}{}", prefix, axes[i], axes[j]), unit, long_name, tensor(i, j));
}

void put_step(io::Series& table, const io::Snapshot& state, std::size_t rows) {
  const auto step = static_cast<double>(state.step);
  std::vector<double>& steps = column(table, "step", "1", "time steps since the start");
  steps.insert(steps.end(), rows, step);
  std::vector<double>& times = column(table, "time", "s", "time since the start");
  times.insert(times.end(), rows, state.time);
}

void put_cell(io::Series& table, const io::Snapshot& state, bool tessellate) {
  const int d = state.grains.dimension;
  put_step(table, state);
  put_strain(table, of_cell(state, cell_strain(state.cell)), d);
  const Mat3 stress = of_cell(state, cell_stress(state));
  put_stress(table, stress, d);
  put_principal(table, stress, d);
  put(table, "void_ratio", "1", "void ratio of the cell, overlaps counted twice", of_cell(state, void_ratio(state)));
  if (tessellate) {
    const std::vector<double> volumes = power_cell_volumes(state);
    const VolumeState filled = volume_state(state, whole(state), grain_dyads(state), volumes);
    put(table, "void_ratio_tessellation", "1", "void ratio from the sum of the power cells", filled.void_ratio);
  }
  put(table, "coordination_number", "1", "2 Nc/N", coordination(state).all);
  for (int a = 0; a < d; ++a)
    put(table, fmt::format("cell_length_{}", axes[a]), "m", "length of the cell vector",
        state.cell.matrix.col(a).norm());
  const std::vector<double>& radii = state.grains.radius;
  put(table, "mean_radius", "m", "mean radius of the grains",
      std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size()));
}

Local local(const io::Snapshot& reference, const io::Snapshot& state) {
  Local l{grain_dyads(state), power_cell_volumes(state), std::vector<Mat3>(state.grains.size(), Mat3::Identity())};
  if (&reference == &state) return l;
  const std::vector<Simplex> simplices = delaunay(reference);
  l.deformation = grain_gradients(reference, state, simplices, simplex_gradients(reference, state, simplices));
  return l;
}

void put_volume(io::Series& table, const io::Snapshot& reference, const io::Snapshot& state, double number,
                const Volume& volume, const Local& local) {
  const int d = state.grains.dimension;
  if (volume.grains.empty())
    throw DataError(
        fmt::format("step {}: no grain lies in {}; give coordinates inside the cell, m", state.step, volume.name));
  const VolumeState v = volume_state(state, volume, local.dyads, local.cell_volumes);
  put_step(table, state);
  put(table, "volume_of_interest", "1", "number of the volume, from 0", number);
  put(table, "grains", "1", "grains in it whose power cells lie in the assembly", v.grains);
  const Vec3 middle = centre(state, volume);
  for (int a = 0; a < d; ++a)
    put(table, fmt::format("centre_{}", axes[a]), "m", "mean of the centres of its grains", middle[a]);
  put(table, "volume", d == 3 ? "m3" : "m2", "sum of its grains' power cells", v.volume);
  put(table, "void_ratio", "1", "void ratio from the power cells", v.void_ratio);
  put_stress(table, v.stress, d);
  put_principal(table, v.stress, d);
  // A gradient needs one grain more than the space has axes.
  const bool enough = volume.grains.size() > static_cast<std::size_t>(d);
  const Mat3 strain = enough ? natural_strain(best_fit_gradient(reference, state, volume.grains, volume.images))
                             : Mat3::Constant(no_value);
  put_strain(table, strain, d);
  put(table, "strain_axial", "1", "natural strain along the loading axis", strain(d - 1, d - 1));
}

void put_grains(io::Series& table, const io::Snapshot& state, const Local& local) {
  const int d = state.grains.dimension;
  const std::vector<Part> part = parts(state);
  const bool fill = std::ranges::count(part, Part::fill) > 0;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    put_step(table, state);
    put(table, "body_id", "1", "identity of the grain", static_cast<double>(state.grains.body_id[i]));
    for (int a = 0; a < d; ++a)
      put(table, fmt::format("position_{}", axes[a]), "m", "position, not wrapped", state.grains.position[i][a]);
    put(table, "radius", "m", "radius", state.grains.radius[i]);
    put(table, "copy", "1", "copy of the representative volume it is of, -1 for none", state.grains.copy_id[i]);
    if (fill)
      put(table, "part", "1", "0: reinforced soil, 1: fill, 2: node of a geotextile", static_cast<double>(part[i]));
    put(table, "cell_volume", d == 3 ? "m3" : "m2", "volume of the power cell", local.cell_volumes[i]);
    // The power cell of a grain at the rim reaches outside, so that its stress has no volume to refer to.
    put_stress(table,
               local.cell_volumes[i] > 0 ? Mat3(local.dyads[i] / local.cell_volumes[i]) : Mat3::Constant(no_value), d);
    put_strain(table, natural_strain(local.deformation[i]), d);
  }
}

void put_fabric(io::Series& table, const io::Snapshot& state) {
  const int d = state.grains.dimension;
  const Fabric f = fabric(state);
  put_step(table, state);
  put(table, "strain_axial", "1", "natural strain of the cell along the loading axis",
      of_cell(state, cell_strain(state.cell)(d - 1, d - 1)));
  put(table, "contact_normal", "1", "fabric tensor of the contact normals, thesis Eq. 3.6", f.normals, d);
  put(table, "normal_force", "N", "fabric tensor of the normal forces, thesis Eq. 3.7", f.normal_force, d);
  put(table, "tangential_force", "N", "fabric tensor of the tangential forces, symmetric part, thesis Eq. 3.8",
      symmetric(f.tangential_force), d);
  put(table, "a_c", "1", "anisotropy of the contact normals, thesis Eq. 3.9", f.a_c);
  put(table, "a_n", "1", "anisotropy of the normal forces", f.a_n);
  put(table, "a_t", "1", "anisotropy of the tangential forces", f.a_t);
  const StressForceFabric s = stress_force_fabric(state, f);
  put(table, "stress_obliquity", "1", "q/p from the stress", s.stress);
  put(table, "stress_obliquity_from_fabric", "1",
      "q/p from the anisotropies: 2/5 (a_c + a_n + 3/2 a_t), in 2D 1/2 (a_c + a_n + a_t)", s.fabric);
  const Coordination z = coordination(state, those(parts(state), Part::soil));
  put(table, "coordination_number", "1", "2 Nc/N", z.all);
  put(table, "mechanical_coordination_number", "1", "(2 Nc - N1)/(N - N0 - N1), Thornton (2000)", z.mechanical);
  put(table, "backbone_coordination_number", "1", "without rattlers, taken out until none is left", z.backbone);
  put(table, "rattlers", "1", "grains outside the backbone", static_cast<double>(z.rattlers));
  const ForceChains c = force_chains(state);
  put(table, "force_chains", "1", "chains of three grains or more", static_cast<double>(c.count));
  put(table, "force_chain_length", "1", "mean number of grains in a chain", c.mean_length);
  put(table, "grains_in_force_chains", "1", "share of the grains", c.grains_in_chains);
}

void put_histogram(io::Series& table, const io::Snapshot& state) {
  const Coordination z = coordination(state, those(parts(state), Part::soil));
  for (std::size_t k = 0; k < z.histogram.size(); ++k) {
    put_step(table, state);
    put(table, "contacts", "1", "contacts of a grain", static_cast<double>(k));
    put(table, "grains", "1", "grains with so many contacts", static_cast<double>(z.histogram[k]));
  }
}

void put_rose(io::Series& table, const io::Snapshot& state, std::size_t classes) {
  const auto rows = [&](double plane, const Rose& rose) {
    for (std::size_t k = 0; k < rose.angle.size(); ++k) {
      put_step(table, state);
      put(table, "plane", "1", "0: angle from the loading axis; 1: in the xy plane; 2: in the xz plane", plane);
      put(table, "angle", "deg", "middle of the class", rose.angle[k] * 180 / std::numbers::pi);
      put(table, "contacts", "1", "contacts in the class; in a plane both directions of each", rose.contacts[k]);
      put(table, "density", "1", "contacts in the class over those of an isotropic packing", rose.density[k]);
      put(table, "normal_force", "N", "mean normal force in the class", rose.normal_force[k]);
    }
  };
  if (state.grains.dimension == 3) rows(0, polar_rose(state, classes / 4));
  rows(1, plane_rose(state, 0, 1, classes));
  if (state.grains.dimension == 3) rows(2, plane_rose(state, 0, 2, classes));
}

void put_chains(io::Series& table, const io::Snapshot& state) {
  const ForceChains chains = force_chains(state);
  const io::ContactsRecord& c = state.contacts;
  std::vector<std::size_t> links;
  for (std::size_t k = 0; k < c.size(); ++k)
    if (chains.chain[k] >= 0) links.push_back(k);
  const auto id = [&](std::size_t k, std::size_t side) {
    return static_cast<double>(state.grains.body_id[static_cast<std::size_t>(c.bodies[k][side])]);
  };
  put_step(table, state, links.size());
  put_rows(table, "chain", "1", "number of the chain, from 0", links,
           [&](std::size_t k) { return static_cast<double>(chains.chain[k]); });
  put_rows(table, "first", "1", "body_id of the first grain", links, [&](std::size_t k) { return id(k, 0); });
  put_rows(table, "second", "1", "body_id of the second grain", links, [&](std::size_t k) { return id(k, 1); });
  put_rows(table, "normal_force", "N", "normal force, compression positive", links,
           [&](std::size_t k) { return c.normal_force[k]; });
}

bool lacks_values(const io::Series& table) {
  return std::ranges::any_of(table.columns, [](const io::Column& column) {
    return std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
  });
}

io::Series chosen_columns(const io::Series& table, const std::string& names) {
  if (names.empty()) return table;
  io::Series chosen;
  std::vector<std::string> known;
  for (const io::Column& column : table.columns) known.push_back(column.name);
  for (const std::string& name : parts_of_list(names)) {
    const io::Column* column = table.find(name);
    if (!column) throw UsageError(fmt::format("--columns: no column '{}'{}", name, suggestion(name, known)));
    if (chosen.find(name)) throw UsageError(fmt::format("--columns: {} is named twice", name));
    chosen.columns.push_back(*column);
  }
  return chosen;
}

}  // namespace soilweave::analysis
