// Closed surfaces that hold grains: how deep a point lies inside, and the bag of the thesis.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/settings.h"
#include "core/tensor.h"
#include "packing/profile.h"

namespace soilweave::packing {

class Container {
 public:
  virtual ~Container() = default;
  /// Distance to the surface, m; negative outside. Must be exact for points within a few grains of the surface.
  virtual double depth(const Vec3& point) const = 0;
  /// Corners of an upright box around it, m.
  virtual Vec3 low() const = 0;
  virtual Vec3 high() const = 0;
  /// m3, of what lies at least `depth` m inside.
  virtual double volume(double depth = 0) const = 0;
  /// Where a mesh of the surface of a box of so many cells lies on the parallel surface `outside` m beyond, m. box: its
  /// nodes, u, v, w in [-1, 1], of which one at least is -1 or 1. even: cells roughly of one size; else each face of
  /// the container is divided by itself, where it has any.
  virtual std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                                   bool even) const = 0;
  /// The point of that parallel surface nearest to one near it.
  virtual Vec3 nearest(const Vec3& point, double outside) const = 0;
};

/// A filled bag: flat square faces with rounded corners, and round sides between them.
struct FilledBag : Container, Profile {
  double corner_radius = 0;  // m, of the faces

  Vec3 low() const override { return -high(); }
  Vec3 high() const override { return {reach(), reach(), half_height}; }
  /// The top and bottom of the box reach as far down the sides as lines of equal length ask for; or, each by itself, to
  /// where the faces cease to be flat.
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;

 protected:
  /// Its section and its corners.
  void read(Settings& table);
  /// Of the corners' radius, m: how much larger it is so far beyond the faces' edges.
  virtual double rounder(double beyond) const = 0;
};

/// What lies no farther than side_radius from a flat core in z = 0, cut at half_height: sides bulge around the corners
/// too.
struct Pillow final : FilledBag {
  Pillow() { corner_radius = 0.0357; }
  explicit Pillow(Settings& table);
  double depth(const Vec3& point) const override;
  /// Areas A + P t + pi t^2 at the distance t around a flat core of area A and perimeter P (Steiner), over the height.
  double volume(double depth = 0) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;

 private:
  double rounder(double beyond) const override { return beyond; }
  /// The core's point nearest to this one.
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
