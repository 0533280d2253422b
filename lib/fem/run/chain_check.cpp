// Sizes of a geosynthetic against the boundary that it follows.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/chain_check.h"

#include <fmt/format.h>

#include <string>

#include "core/error.h"

namespace soilweave::fem {
namespace {

// Largest sizes, over the length of the boundary: a sheet is thinner than long, and no bar is longer than the sheet. A
// sheet may begin far from the soil.
constexpr double thickest = 0.5, longest_bar = 1, longest_overhang = 10;

double length_of(const Mesh& mesh, const std::vector<std::string>& along) {
  double length = 0;
  for (const std::string& name : along)
    for (const auto& edge : mesh.boundary_with_edges(name).ends)
      length += (mesh.nodes[edge[1]] - mesh.nodes[edge[0]]).norm();
  return length;
}

}  // namespace

void check_chain(Settings& geosynthetic, const ModelSetup& setup, double radius) {
  double length = 0;
  try {
    length = length_of(setup.soil.mesh, setup.along);
  } catch (const DataError&) {
    return;  // a mistake of geosynthetic.along
  }
  const auto judge = [&](const char* key, double size, double most) {
    if (geosynthetic.has(key) && size > most * length * (1 + 1e-9))
      geosynthetic.mistake(key,
                           fmt::format("{0:.4g} m, where the boundary that the chain follows is {1:.4g} m long; at "
                                       "most {2:.4g} m; if {0:.4g} mm are meant, write \"{0:.4g} mm\"",
                                       size, length, most * length));
  };
  judge("radius", radius, thickest);
  judge("spacing", setup.spacing, longest_bar);
  judge("overhang", setup.overhang, longest_overhang);
}

}  // namespace soilweave::fem
