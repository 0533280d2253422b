// Closed surfaces that hold grains: the depth of a point inside them, and the bag of the thesis.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/tensor.h"
#include "core/text/settings.h"
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
  /// Returns where a mesh of the surface of a box of so many cells lies on the parallel surface `outside` m beyond, m.
  /// box: its nodes u, v, w in [-1, 1], at least one of which is -1 or 1. even: cells of about one size; otherwise each
  /// face of the container, if it has faces, is divided by itself.
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
  /// If even, top and bottom of the box reach down the sides until lines have equal length. Otherwise each reaches to
  /// the end of its flat face.
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;

 protected:
  /// Reads the section and the corners.
  void read(Settings& table);
  /// Returns by how much the corner radius is larger at a distance `beyond` outside the faces' edges, m.
  virtual double rounder(double beyond) const = 0;
};

/// All points within side_radius of a flat core in z = 0, cut at half_height. Its sides bulge around the corners too.
struct Pillow final : FilledBag {
  /// The thesis's bag, with its default corner radius.
  Pillow() { corner_radius = 0.0357; }
  /// Reads a pillow from [container].
  explicit Pillow(Settings& table);
  double depth(const Vec3& point) const override;
  /// Integrates A + P t + pi t^2 over the height: the area within distance t of a flat core of area A and perimeter P
  /// (Steiner).
  double volume(double depth = 0) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;

 private:
  double rounder(double beyond) const override { return beyond; }
  /// Returns the nearest point of the core.
  Vec3 foot(const Vec3& point) const;
};

/// An upright box.
struct Box final : Container {
  Vec3 lower, upper;  // m

  double depth(const Vec3& point) const override { return (point - lower).cwiseMin(upper - point).minCoeff(); }
  Vec3 low() const override { return lower; }
  Vec3 high() const override { return upper; }
  double volume(double depth = 0) const override { return (upper - lower - Vec3::Constant(2 * depth)).prod(); }
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;
};

}  // namespace soilweave::packing
