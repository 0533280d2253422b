// The response of a bag to surcharge (thesis section 5.3.4), up to its ultimate bearing capacity.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bag of width B and height H lies under a surcharge sigma_as. As it flattens it spreads, the geotextile stretches
// around it, and the hoop tension t_h presses the soil together from top, bottom and sides. So the soil inside carries
// more than the load outside. Balance of forces on half the bag, with strains eps_a and eps_r of the soil:
//
//   vertical  sigma_as = sigma_a - 4 t_h / [B (1 - eps_r)^2]
//   lateral   2 (B + H) t_h = (sigma_r - sigma_rs) B H (1 - eps_a)(1 - eps_r)
//
// Eliminating t_h gives Eq. 5.3; the hoop strain is eps_h = t_h / J (Eq. 5.16).
//
// The soil's own path is computed first (path.h): stresses and strains as functions of its mean stress p alone. At each
// state on that path the balance gives the surcharge and the hoop strain. A response thus walks up the path and reads
// off both. It ends where the hoops reach their stated fraction of the strength: there sigma_as is the ultimate bearing
// capacity. It may end earlier, where the soil fails or the surcharge asked for is reached (enum End).
//
// Compaction is a first stretch of the path: the response then starts at its end, with the strains it left.
// A lateral stress sigma_rs outside, constant or a function of the surcharge, describes the soil around a bag.
//
//   const Response response({.soil = soil, .geotextile = geotextile, .bag = {0.4, 0.08}});
//   const Point ultimate = response.last();          // surcharge, strains, hoop tension
//   const Point service = response.at_surcharge(500e3);
#pragma once

#include <optional>
#include <vector>

#include "gws/solution/geotextile.h"
#include "gws/solution/path.h"

namespace soilweave::gws {

/// Lateral stress sigma_rs outside the bag as a function of the surcharge: linear between the points, constant beyond.
struct LateralStress {
  std::vector<double> surcharge, lateral;  // Pa; empty: no lateral stress

  /// Returns a lateral stress that does not depend on the surcharge.
  static LateralStress constant(double stress) { return {{0}, {stress}}; }
  /// Returns the lateral stress at a surcharge, Pa.
  double at(double surcharge) const;
  /// Throws DataError if surcharges fall (the model cannot unload), if a stress is negative, or if the lateral stress
  /// rises so fast that it alone carries the surcharge, at (1 + H/B)/(2 H/B) in the beginning.
  void check(const Bag& bag) const;
};

inline constexpr Parameter bag_extent{"extent",
                                      "m",
                                      0,
                                      100,
                                      true,
                                      "width or height of the bag",
                                      "a bag has an extent; millimetres are written \"400 mm\""};
inline constexpr Parameter strength_fraction_range{"strength_fraction",
                                                   "1",
                                                   0,
                                                   1,
                                                   false,
                                                   "share of the strength at which the bag fails",
                                                   "a hoop bears no more than its strength"};
inline constexpr Parameter tolerance_range{"tolerance",
                                           "1",
                                           1e-10,
                                           1e-2,
                                           false,
                                           "relative error of surcharge and settlement",
                                           "below it rounding takes over, above it the result means little"};

/// Input of a response.
struct Case {
  Soil soil;
  Geotextile geotextile;
  Bag bag;
  LateralStress lateral;
  double strength_fraction = 0.5;  // fraction of the strength at which the bag counts as failed (thesis section 5.4)
  double tolerance = 1e-6;         // relative error of surcharge and settlement
  std::optional<double> initial_settlement;  // axial strain of compaction before the response begins, 1
  std::optional<double> initial_surcharge;   // compaction as a pressure, Pa
  std::optional<double> until;               // surcharge at which to end, Pa, even if the bag carries more

  /// Returns the hoop strain at the end: strength_fraction times strength over stiffness, at most the failure strain.
  double hoop_limit() const;
};

/// Bag, soil and geotextile at one surcharge. Strains are fractions, counted from the unloaded bag.
struct Point {
  double surcharge = 0, lateral = 0;  // outside the bag, Pa
  double hoop_strain = 0, hoop_tension = 0;
  SoilState soil;  // strains in percent

  /// Returns the axial strain as a fraction.
  double settlement() const { return soil.strain_axial / 100; }
};

/// Throws DataError with all values that are out of range, and why: constants, bag, geotextile, fraction, tolerance,
/// lateral stress.
void check(const Case& what);

/// The whole response. The constructor throws DataError if it cannot begin: the constants are inadmissible at the first
/// stress, or the compaction is beyond the bag's capacity.
class Response {
 public:
  /// Computes the whole response.
  explicit Response(const Case& what);

  /// Returns why the response ended.
  End end() const { return end_; }
  /// Returns the state after compaction, or the first state if there is none.
  const Point& start() const { return start_; }
  /// Returns the last state. It is the ultimate state if end() is strength or failure_strain.
  const Point& last() const { return last_; }
  /// Returns whether the bag failed before the surcharge asked for.
  bool failed() const { return end_ != End::surcharge; }
  /// Returns the number of steps along the path.
  std::size_t steps() const { return path_.steps(); }

  /// Returns the state at a surcharge between start() and last(), or at an axial strain counted from the unloaded bag.
  /// Throws DataError that names the range. Roots are bracketed (TOMS 748) to the last bits.
  Point at_surcharge(double surcharge) const;
  Point at_strain(double axial_strain) const;
  /// Returns n+1 states at equal steps of settlement, from start() to the surcharge `to` (default: the last).
  std::vector<Point> points(std::size_t n, std::optional<double> to = std::nullopt) const;

 private:
  Point point(double x) const;
  void march();
  void compact();
  template <class Value>
  double root(double low, double high, const Value& value) const;

  Case case_;
  Path path_;
  End end_ = End::none;
  double begin_ = 0, finish_ = 0;  // ln p
  Point start_, last_;
};

}  // namespace soilweave::gws
