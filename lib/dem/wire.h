// A yarn as a tension-only spring along a piecewise-linear curve: it yields, unloads, breaks. Geometry and forces of
// one yarn; it knows nothing of nodes and lists.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace soilweave::dem {

/// Tension against strain of a yarn: straight between points, from the origin on; beyond the last point it breaks.
/// Below the largest strain so far it unloads and reloads along `unloading` from the plastic strain (dem-laws §9).
struct WireCurve {
  std::string name;
  std::vector<double> strain;   // ascending, 1
  std::vector<double> tension;  // N
  double unloading = 0;         // N per unit of strain

  double breaking_strain() const { return strain.back(); }
  /// N, on the curve of first loading, 0 to breaking_strain().
  double loading(double e) const {
    const auto k = static_cast<std::size_t>(std::upper_bound(strain.begin(), strain.end() - 1, e) - strain.begin());
    const double e0 = k ? strain[k - 1] : 0, t0 = k ? tension[k - 1] : 0;
    return t0 + (e - e0) * (tension[k] - t0) / (strain[k] - e0);
  }
  /// N per unit of strain, the steepest that the curve ever is.
  double stiffest() const {
    double most = unloading;
    for (std::size_t k = 0; k < strain.size(); ++k) {
      const double e0 = k ? strain[k - 1] : 0, t0 = k ? tension[k - 1] : 0;
      most = std::max(most, (tension[k] - t0) / (strain[k] - e0));
    }
    return most;
  }
};

/// What a yarn remembers.
struct WireMemory {
  double largest_strain = 0;
  bool broken = false;
};

/// Tension at a strain, N; moves the memory along. Compression carries nothing.
inline double pull(const WireCurve& curve, double strain, WireMemory& memory) {
  if (memory.broken) return 0;
  if (strain > curve.breaking_strain()) {
    memory.broken = true;
    return 0;
  }
  if (strain >= memory.largest_strain) {
    memory.largest_strain = strain;
    return curve.loading(strain);
  }
  return std::max(0.0, curve.loading(memory.largest_strain) - curve.unloading * (memory.largest_strain - strain));
}

}  // namespace soilweave::dem
