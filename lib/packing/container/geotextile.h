// Woven geotextiles as a quadrilateral mesh of nodes and yarns, on a bag or flat.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "dem/contact/model.h"
#include "files/records.h"
#include "packing/container/container.h"

namespace soilweave::packing {

/// Nodes of a woven geotextile, and the yarns between them by indices of nodes.
struct Fabric {
  /// One yarn.
  struct Yarn {
    std::int32_t first, second, family;  // family as in files
  };
  std::vector<Vec3> nodes;  // m
  std::vector<Yarn> yarns;
};

/// Properties of nodes. Yarns have no tension where they are laid.
struct NodeRecipe {
  double radius = 0.0025;     // m
  double density = 444e3;     // kg/m3, scaled
  std::int32_t material = 1;  // material_id
  std::int32_t geotextile = 0;

  /// Reads node_radius, node_density, material and geotextile_id.
  static NodeRecipe read(Settings& table);
};

/// Returns the mesh of a box of cells[0] x cells[1] x cells[2] quadrilaterals on the container, with node centres
/// `outside` m beyond its surface. even: yarns are as equally long as the shape allows; otherwise each face of the
/// container is divided by itself. done: callback with the share of the work, 0 to 1.
Fabric wrap(const Container& bag, const std::array<int, 3>& cells, double outside, bool even = true, int threads = 1,
            const std::function<void(double)>& done = {});
/// Returns the numbers of cells for wrap() at which yarns are about `spacing` m apart.
std::array<int, 3> cells_of(const Container& bag, double spacing, double outside);
/// Returns a sheet of cells[0] x cells[1] quadrilaterals in the plane z = height, centred on the z axis, with yarns
/// `spacing` m apart.
Fabric sheet(const std::array<int, 2>& cells, double spacing, double height);

/// Returns the number of geotextiles that yarns of the state name.
std::size_t geotextiles_of(const io::Snapshot& state);
/// Returns `count` geotextiles with an arbitrary curve, for states whose yarns have no tension.
std::vector<dem::WireCurve> resting_geotextiles(std::size_t count);

/// Adds the fabric's nodes, with copy_id -1, after the grains, and its yarns. The fabric gets the next free number.
void add(const Fabric& fabric, const NodeRecipe& recipe, io::Snapshot& state);

}  // namespace soilweave::packing
