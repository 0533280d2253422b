// Checks that a state and a model belong together.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/described.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem/state/cell.h"

namespace soilweave::dem {
namespace {

// Part of a plane's unit normal along an axis below which the plane is parallel to it.
constexpr double least_across = 1e-6;

void demand_known(const std::vector<std::int32_t>& ids, std::size_t known, const char* has, const char* table) {
  for (const std::int32_t id : ids)
    if (id < 0 || static_cast<std::size_t>(id) >= known)
      throw DataError(
          fmt::format("the packing has {} {}, the scenario describes {}: add {} tables", has, id, known, table));
}

// Throws DataError for an unbroken yarn that is stretched beyond its breaking strain, and shorter through a face.
void demand_inside(const io::Snapshot& state, const Model& model) {
  const Cell cell(state.cell, state.grains.dimension);
  if (!cell.any_periodic()) return;
  const io::YarnsRecord& y = state.yarns;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (y.broken[k]) continue;
    const auto [one, two] = y.nodes[k];
    const Vec3 &from = state.grains.position[static_cast<std::size_t>(one)],
               &to = state.grains.position[static_cast<std::size_t>(two)];
    const double length = (to - from).norm(), strain = length / y.rest_length[k] - 1;
    if (strain <= model.geotextiles[static_cast<std::size_t>(y.geotextile_id[k])].breaking_strain()) continue;
    const Vec3i image = cell.nearest_image(from, to);
    if (image.isZero()) continue;
    const int axis = image[0] != 0 ? 0 : image[1] != 0 ? 1 : 2;
    throw DataError(fmt::format(
        "yarn {} of {:.4g} m passes through the periodic face along {}: its nodes {} and {} are {:.4g} m apart in the "
        "cell, {:.4g} m through the face, and yarns have no images; end the fabric inside the cell with free edges, "
        "and do not wrap the positions of its nodes",
        k, y.rest_length[k], "xyz"[axis], one, two, length, (to + cell.matrix() * image.cast<double>() - from).norm()));
  }
}

}  // namespace

const io::Snapshot& described(const io::Snapshot& state, const Model& model) {
  const std::size_t materials = model.materials.size();
  demand_known(state.grains.material_id, materials, "grains of material", "[[material]]");
  demand_known(state.planes.material_id, materials, "planes of material", "[[material]]");
  demand_known(state.yarns.geotextile_id, model.geotextiles.size(), "yarns of geotextile", "[[geotextile]]");
  demand_inside(state, model);
  return state;
}

void demand_in_plane(const io::Snapshot& state, const Vec3& gravity) {
  if (state.grains.dimension != 2) return;
  const std::string why = "along z, and the packing is of disks in the plane of x and y";
  if (gravity.z() != 0) throw DataError(fmt::format("numerics.gravity acts {}: give it along y", why));
  for (std::size_t k = 0; k < state.planes.point.size(); ++k)
    for (const auto& [name, vector] :
         {std::pair("normal", &state.planes.normal), std::pair("velocity", &state.planes.velocity)})
      if ((*vector)[k].z() != 0)
        throw DataError(fmt::format("plane {}: its {} has a part {}: leave that part out", k, name, why));
}

std::optional<std::pair<std::size_t, int>> plane_between_images(const io::Snapshot& state) {
  const io::GrainsRecord& g = state.grains;
  const double widest = 2 * *std::max_element(g.radius.begin(), g.radius.end());
  for (int a = 0; a < g.dimension; ++a) {
    if (!state.cell.periodic[static_cast<std::size_t>(a)]) continue;
    double low = INFINITY, high = -INFINITY;
    for (std::size_t i = 0; i < g.size(); ++i)
      low = std::min(low, g.position[i][a] - g.radius[i]), high = std::max(high, g.position[i][a] + g.radius[i]);
    if (state.cell.matrix(a, a) - (high - low) >= widest) continue;
    for (std::size_t k = 0; k < state.planes.normal.size(); ++k)
      if (std::abs(state.planes.normal[k].normalized()[a]) > least_across) return std::pair(k, a);
  }
  return std::nullopt;
}

void demand_footing(const io::Snapshot& state, const Vec3& gravity, bool clamped) {
  if (clamped || std::ranges::any_of(state.planes.normal, [&](const Vec3& n) { return n.dot(gravity) < 0; })) return;
  for (int a = 0; a < state.grains.dimension; ++a)
    if (gravity[a] != 0)
      throw DataError(fmt::format(
          "numerics.gravity acts along {}, along which {}: the grains would fall for ever; leave it out, or {}",
          "xyz"[a],
          state.cell.periodic[static_cast<std::size_t>(a)] ? "the cell is periodic" : "no plane stops the grains",
          state.cell.periodic[static_cast<std::size_t>(a)]
              ? fmt::format("take a packing in a cell that is open along {} and give a [[plane]]", "xyz"[a])
              : "give a [[plane]] below them whose normal points up"));
}

}  // namespace soilweave::dem
