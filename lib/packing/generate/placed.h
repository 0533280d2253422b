// Grains placed one by one in a periodic cell without overlap.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/tensor.h"

namespace soilweave::packing {

/// Grains in a periodic cell. Bins one largest diameter wide limit a test for overlaps to 27 bins (9 in 2D).
class Placed {
 public:
  /// size: edges of the upright cell, m. largest_diameter: limit for all grains, m.
  Placed(const Vec3& size, double largest_diameter, int dimension) : size_(size), dimension_(dimension) {
    for (int a = 0; a < 3; ++a)
      bins_[a] = a < dimension ? std::clamp(static_cast<int>(std::floor(size[a] / largest_diameter)), 1, 128) : 1;
    members_.resize(static_cast<std::size_t>(bins_.prod()));
  }

  /// Returns whether a grain at `at`, 0 <= at < size, overlaps no earlier grain.
  bool fits(const Vec3& at, double radius) const {
    const Vec3i home = bin(at);
    // With fewer than three bins along an axis, neighbour offsets would visit a bin twice.
    const Vec3i reach = (bins_.array() >= 3).select(Vec3i::Ones().array(), bins_.array() - 1).min(1);
    for (int dz = -reach[2]; dz <= reach[2]; ++dz)
      for (int dy = -reach[1]; dy <= reach[1]; ++dy)
        for (int dx = -reach[0]; dx <= reach[0]; ++dx)
          for (const auto& [where, r] : members_[index(home + Vec3i(dx, dy, dz))]) {
            Vec3 d = at - where;
            for (int a = 0; a < dimension_; ++a) d[a] -= size_[a] * std::round(d[a] / size_[a]);
            if (d.squaredNorm() < (radius + r) * (radius + r)) return false;
          }
    return true;
  }
  /// Adds a grain, which need not fit.
  void add(const Vec3& at, double radius) { members_[index(bin(at))].emplace_back(at, radius); }

 private:
  /// Returns the bin of a position.
  Vec3i bin(const Vec3& at) const {
    Vec3i b = Vec3i::Zero();
    for (int a = 0; a < dimension_; ++a) b[a] = std::min(static_cast<int>(at[a] / size_[a] * bins_[a]), bins_[a] - 1);
    return b;
  }
  /// Returns the index of a bin, folded into the cell.
  std::size_t index(const Vec3i& b) const {
    Vec3i folded;
    for (int a = 0; a < 3; ++a) folded[a] = (b[a] + bins_[a]) % bins_[a];
    return static_cast<std::size_t>((folded[2] * bins_[1] + folded[1]) * bins_[0] + folded[0]);
  }

  Vec3 size_;
  int dimension_;
  Vec3i bins_;
  /// Centres and radii, m, by bin.
  std::vector<std::vector<std::pair<Vec3, double>>> members_;
};

}  // namespace soilweave::packing
