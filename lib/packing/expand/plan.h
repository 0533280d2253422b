// A filter-expand plan in TOML: container, geotextile, materials, growth.
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
  /// Shape of the soil; nullptr: no soil.
  std::unique_ptr<Container> container;
  std::optional<std::array<int, 3>> copies;
  /// Cells of the geotextile around the container.
  std::optional<std::array<int, 3>> wrapping;
  /// Whether all yarns are equally long. False: each face is divided by itself.
  bool even = true;
  /// Distance of the nodes from the container's surface, m.
  double outside = 0;
  /// One flat geotextile.
  struct Sheet {
    /// Quadrilaterals along x and y.
    std::array<int, 2> cells;
    /// Yarn length and position along z, m.
    double spacing, height;
    NodeRecipe nodes;
  };
  std::vector<Sheet> sheets;
  NodeRecipe nodes;
  /// Density of the soil, kg/m3; 0: the packing's.
  double density = 0;
  /// Factor on the representative volume's lengths.
  double scale = 1;
  dem::Model model;
  dem::Numerics numerics;
  std::optional<Growth> growth;
  /// Cell around a reinforced part; then there is no container, geotextile or growth.
  std::optional<Surround> surround;
  /// Files that the plan names.
  std::vector<io::Source> sources;
  /// The plan with all defaults, in TOML.
  std::string resolved;
  /// Stresses of [surround] that were given without a unit, Pa.
  std::vector<BareNumber> bare_stresses;

  /// Returns the depth at which soil begins, m: the inner side of the nodes.
  double soil_depth() const { return wrapping ? nodes.radius - outside : 0; }
};

/// Nodes of a [geotextile_mesh].
struct Laid {
  NodeRecipe nodes;
  /// Distance from the container's surface, m.
  double outside = 0;
};
/// Reads the nodes of [geotextile_mesh].
Laid read_laid(Settings& table);

/// Reads a plan. Throws DataError with all mistakes at once.
Plan read_plan(std::string_view text, const std::string& name, const std::vector<std::string>& overrides);
/// Reads a plan from a document. files: resolves its file names.
Plan read_plan(Settings& document, const NamedFiles& files);
/// Returns every key that a plan may have (core/text/keys.h).
std::vector<Key> plan_keys();

/// Returns copies cut to the container, inside its geotextile, before growth. laid: callback with the share of the
/// geotextile that is done, 0 to 1. Throws DataError if the copies are too small for the container.
io::Snapshot assemble(const io::Snapshot& representative_volume, const Plan& plan,
                      const std::function<void(double)>& laid = {});

/// Sets growth.filling and, if requested, growth.stretch. They bring the cut soil to the void ratio in the part of the
/// container more than `outermost` m deep. The cut leaves a gap of one grain along the surface.
void aim(Growth& growth, const io::Snapshot& assembled, double void_ratio, const Container& container,
         double outermost = 0);

}  // namespace soilweave::packing
