// Yarns as tension-only springs that yield, unload and break.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/simd/lanes.h"

namespace soilweave::dem {

/// Tension of a yarn against strain, linear between points from the origin on. Beyond the last point it breaks.
/// Below its largest strain it unloads and reloads with slope `unloading` (LAWS.md §9).
struct WireCurve {
  /// Name of the geotextile.
  std::string name;
  /// Strains of the points, ascending, 1.
  std::vector<double> strain;
  /// Tensions of the points, N, not negative.
  std::vector<double> tension;
  /// Slope of unloading, N per unit of strain.
  double unloading = 0;
  /// Strength of the fabric in its data sheet, N/m; 0 if unknown, or if the scenario multiplies the tensions.
  double strength = 0;

  /// Returns the strain at which a yarn breaks.
  double breaking_strain() const { return strain.back(); }
  /// Returns the tension of first loading, N, for strains from 0 to breaking_strain().
  template <class T>
  T loading(const T& e) const {
    std::size_t k = strain.size() - 1;
    T t = on_piece(k, e);
    while (k-- > 0) t = select<T>(e < broadcast<T>(strain[k]), on_piece(k, e), t);
    return t;
  }
  /// Returns the steepest slope, N per unit of strain.
  double stiffest() const {
    double most = unloading;
    for (std::size_t k = 0; k < strain.size(); ++k) most = std::max(most, piece(k).slope);
    return most;
  }

 private:
  /// One linear piece of the curve.
  struct Piece {
    /// Strain and tension (N) at its beginning; slope, N per unit of strain.
    double strain, tension, slope;
  };
  /// Returns the piece that ends at point k.
  Piece piece(std::size_t k) const {
    const double e0 = k ? strain[k - 1] : 0, t0 = k ? tension[k - 1] : 0;
    return {e0, t0, (tension[k] - t0) / (strain[k] - e0)};
  }
  /// Returns the tension on the line of piece k, N.
  template <class T>
  T on_piece(std::size_t k, const T& e) const {
    const Piece p = piece(k);
    return p.tension + (e - p.strain) * p.slope;
  }
};

/// History of yarns.
template <class T = double>
struct WireHistory {
  /// Largest strain so far.
  T largest_strain{};
  /// Whether the yarn broke.
  Mask<T> broken{};
};

/// Returns the tension at a strain, N, and updates the history. A yarn carries no compression.
template <class T>
T pull(const WireCurve& curve, const T& strain, WireHistory<T>& history) {
  history.broken = history.broken | (strain > broadcast<T>(curve.breaking_strain()));
  const Mask<T> whole = !history.broken;
  history.largest_strain = select<T>(whole & (strain > history.largest_strain), strain, history.largest_strain);
  const T tension = curve.loading(history.largest_strain) - curve.unloading * (history.largest_strain - strain);
  return masked(whole, maximum(broadcast<T>(0), tension));
}

}  // namespace soilweave::dem
