// The bag of the thesis: flat faces, and sides that bulge all around.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include "packing/container/container.h"

namespace soilweave::packing {

/// All points within side_radius of a flat core in z = 0, cut at half_height.
struct Pillow final : FilledBag {
  static constexpr std::string_view name = "pillow";
  /// Reads a pillow from [container].
  static std::unique_ptr<Container> read(Settings& table, PlanFiles*);

  /// The bag of the thesis, by default.
  Pillow() { corner_radius = 0.0357; }
  double depth(const Vec3& point) const override;
  /// Integrates A + P t + pi t^2 over the height: the area within t of a core of area A and perimeter P (Steiner).
  double volume(double depth = 0) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;

 private:
  double rounder(double beyond) const override { return beyond; }
  /// Returns the nearest point of the core.
  Vec3 foot(const Vec3& point) const;
};

}  // namespace soilweave::packing
