// What filter-expand is told, in TOML: the container, its geotextile, the materials, how the grains grow.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dem/model.h"
#include "io/provenance.h"
#include "packing/expand.h"
#include "packing/geotextile.h"
#include "packing/surround.h"

namespace soilweave::packing {

struct Plan {
  std::unique_ptr<Container> container;  // none: no soil
  std::optional<std::array<int, 3>> copies;
  std::optional<std::array<int, 3>> wrapping;  // cells of the geotextile around the container
  bool even = true;                            // yarns of one length, not each face divided by itself
  double outside = 0;                          // m, of the container's surface: where the nodes around it lie
  struct Sheet {
    std::array<int, 2> cells;
    double spacing, height;  // m
    NodeRecipe nodes;
  };
  std::vector<Sheet> sheets;
  NodeRecipe nodes;
  double density = 0;  // kg/m3 of the soil; 0: the packing's
  double scale = 1;    // of the representative volume
  dem::Model model;
  dem::Numerics numerics;
  std::optional<Growth> growth;
  std::optional<Surround> surround;  // then there is no container, geotextile or growth
  std::vector<io::Source> sources;   // files that the plan named
  std::string resolved;

  /// How far inside the container's surface soil begins, m: where the nodes around it end.
  double soil_depth() const { return wrapping ? nodes.radius - outside : 0; }
};

/// Returns the pillow, cushion or box that a [container] table describes by numbers; none of another shape.
std::unique_ptr<Container> read_shape(const std::string& shape, Settings& table);
/// The nodes of a [geotextile_mesh] and how far beyond the container's surface they lie, m.
struct Laid {
  NodeRecipe nodes;
  double outside = 0;
};
Laid read_laid(Settings& table);

/// All mistakes at once. Throws DataError.
Plan read_plan(std::string_view text, const std::string& name, const std::vector<std::string>& overrides);

/// Copies cut to the container, its geotextile around them, not yet grown. Throws DataError where the representative
/// volume, copied as often as the plan says, is too small for the container. laid: told the share of the geotextile.
io::Snapshot assemble(const io::Snapshot& representative_volume, const Plan& plan,
                      const std::function<void(double)>& laid = {});

/// How far the soil cut to the container is from filling it, up to a depth of `outermost` m, as densely as the
/// representative volume, whose void ratio this is: the cut leaves a gap of a grain's size along the surface. For
/// growth.filling and, where it is asked for, growth.stretch.
void aim(Growth& growth, const io::Snapshot& assembled, double void_ratio, const Container& container,
         double outermost = 0);

}  // namespace soilweave::packing
