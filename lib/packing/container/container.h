// Closed surfaces that hold grains: the depth of a point inside them. The shapes are in shapes/, one file each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/tensor.h"
#include "core/text/named_file.h"
#include "core/text/settings.h"
#include "files/provenance.h"
#include "packing/container/profile.h"

namespace soilweave::packing {

/// A closed surface, with its interior.
class Container {
 public:
  virtual ~Container() = default;
  /// Returns the distance to the surface, m, negative outside. It must be exact within a few grains of the surface.
  virtual double depth(const Vec3& point) const = 0;
  /// Return the corners of an upright box around the container, m.
  virtual Vec3 low() const = 0;
  virtual Vec3 high() const = 0;
  /// Returns the volume that lies at least `depth` m inside, m3.
  virtual double volume(double depth = 0) const = 0;
  /// Maps the nodes of a box mesh onto the parallel surface `outside` m beyond the container. Returns positions, m.
  /// box: nodes (u, v, w) in [-1, 1], at least one of which is -1 or 1. cells: cells of the box along x, y, z. even:
  /// cells of about one size; otherwise each face of the container, if it has faces, is divided by itself.
  virtual std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                                   bool even) const = 0;
  /// Returns the point of that parallel surface nearest to a point near it.
  virtual Vec3 nearest(const Vec3& point, double outside) const = 0;
};

/// A filled bag: flat square faces with rounded corners, and round sides between them.
struct FilledBag : Container, Profile {
  double corner_radius = 0;  // radius of the faces' corners, m

  Vec3 low() const override { return -high(); }
  Vec3 high() const override { return {reach(), reach(), half_height}; }
  /// If even, top and bottom of the box extend down the sides, so that all cells of a hoop are equally long. Otherwise
  /// they end at the edge of the flat face.
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;

 protected:
  /// Reads the section and the corners.
  void read_section(Settings& table);
  /// Returns the increase of the corner radius at the distance `beyond` outside the faces' edges, m.
  virtual double rounder(double beyond) const = 0;
};

/// The files that a plan names, for containers that are read from one.
struct PlanFiles {
  const NamedFiles& names;
  std::vector<io::Source>& sources;  // receives the digest of each file read
};

/// Returns the shapes that [container] may have, one for each file in shapes/. A new shape is a new file there.
const std::vector<std::string>& shapes();
/// Reads the container of a shape from [container]; each shape reads its own keys. Mistakes are collected in the
/// table's document. Returns nullptr for an unknown shape, for a mistake in the file's name, and for a container from a
/// file if `files` is null.
std::unique_ptr<Container> read_container(std::string_view shape, Settings& table, PlanFiles* files = nullptr);

}  // namespace soilweave::packing
