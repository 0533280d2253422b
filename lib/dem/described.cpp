// Whether a state and a model belong together.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/described.h"

#include <fmt/format.h>

#include "core/error.h"

namespace soilweave::dem {
namespace {

void demand_known(const std::vector<std::int32_t>& ids, std::size_t known, const char* has, const char* table) {
  for (const std::int32_t id : ids)
    if (id < 0 || static_cast<std::size_t>(id) >= known)
      throw DataError(
          fmt::format("the packing has {} {}, the scenario describes {}: add {} tables", has, id, known, table));
}

}  // namespace

const io::Snapshot& described(const io::Snapshot& state, const Model& model) {
  const auto materials = std::visit([](const auto& m) { return m.size(); }, model.materials);
  demand_known(state.grains.material_id, materials, "grains of material", "[[material]]");
  demand_known(state.planes.material_id, materials, "planes of material", "[[material]]");
  demand_known(state.yarns.geotextile_id, model.geotextiles.size(), "yarns of geotextile", "[[geotextile]]");
  return state;
}

void demand_footing(const io::Snapshot& state, const Vec3& gravity) {
  for (int a = 0; a < state.grains.dimension; ++a) {
    if (gravity[a] == 0) continue;
    if (!state.cell.periodic[static_cast<std::size_t>(a)]) return;
    for (const Vec3& normal : state.planes.normal)
      if (normal.dot(gravity) < 0) return;
  }
  for (int a = 0; a < state.grains.dimension; ++a)
    if (gravity[a] != 0)
      throw DataError(
          fmt::format("numerics.gravity acts along {}, along which the cell is periodic: the grains would fall for "
                      "ever; leave it out, or take a packing in a cell that is open along {} and give a [[plane]]",
                      "xyz"[a], "xyz"[a]));
}

}  // namespace soilweave::dem
