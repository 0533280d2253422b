// A plan of filter-expand, in TOML: the container, its geotextile, the materials, the growth of the grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dem/contact/model.h"
#include "files/provenance.h"
#include "packing/container/geotextile.h"
#include "packing/expand/expand.h"
#include "packing/expand/surround.h"

namespace soilweave::packing {

/// A whole plan.
struct Plan {
  std::unique_ptr<Container> container;  // nullptr: no soil
  std::optional<std::array<int, 3>> copies;
  std::optional<std::array<int, 3>> wrapping;  // cells of the geotextile around the container
  bool even = true;                            // yarns of one length; false: each face divided by itself
  double outside = 0;                          // distance of the nodes from the container's surface, m
  /// One flat geotextile.
  struct Sheet {
    std::array<int, 2> cells;
    double spacing, height;  // m
    NodeRecipe nodes;
  };
  std::vector<Sheet> sheets;
  NodeRecipe nodes;
  double density = 0;  // density of the soil, kg/m3; 0: the packing's
  double scale = 1;    // factor on the representative volume's lengths
  dem::Model model;
  dem::Numerics numerics;
  std::optional<Growth> growth;
  std::optional<Surround> surround;  // if set, there is no container, geotextile or growth
  std::vector<io::Source> sources;   // files that the plan names
  std::string resolved;

  /// Returns how far inside the container's surface soil begins, m: at the inner side of the nodes.
  double soil_depth() const { return wrapping ? nodes.radius - outside : 0; }
};

/// Nodes of a [geotextile_mesh], with their distance from the container's surface, m.
struct Laid {
  NodeRecipe nodes;
  double outside = 0;
};
/// Reads the nodes of [geotextile_mesh].
Laid read_laid(Settings& table);

/// Reads a plan. Throws DataError with all mistakes at once.
Plan read_plan(std::string_view text, const std::string& name, const std::vector<std::string>& overrides);
/// Reads a plan from a document. files: how its file names are resolved.
Plan read_plan(Settings& document, const NamedFiles& files);
/// Returns every key that a plan may have (core/text/keys.h).
std::vector<Key> plan_keys();

/// Returns copies cut to the container, with its geotextile around them, before growth. Throws DataError if the copies
/// of the representative volume are too small for the container. laid: callback with the share of the geotextile.
io::Snapshot assemble(const io::Snapshot& representative_volume, const Plan& plan,
                      const std::function<void(double)>& laid = {});

/// Sets growth.filling and, if requested, growth.stretch: how far the cut soil is from filling the container, up to a
/// depth of `outermost` m, as densely as the representative volume of this void ratio. The cut leaves a gap of one
/// grain along the surface.
void aim(Growth& growth, const io::Snapshot& assembled, double void_ratio, const Container& container,
         double outermost = 0);

}  // namespace soilweave::packing
