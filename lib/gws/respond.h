// The response of a bag to surcharge (thesis section 5.3.4), up to its ultimate bearing capacity.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gws/geotextile.h"
#include "gws/path.h"

namespace soilweave::gws {

/// Lateral stress sigma_rs outside the bag as a function of the surcharge: straight between the points, constant beyond
/// them.
struct LateralStress {
  std::vector<double> surcharge, lateral;  // Pa; empty: none

  static LateralStress constant(double stress) { return {{0}, {stress}}; }
  double at(double surcharge) const;
  /// Throws DataError: surcharges that fall (the model cannot unload), negative stresses, or a lateral stress that
  /// rises so fast with the surcharge that it alone would carry the rise, (1 + H/B)/(2 H/B) in the beginning.
  void check(const Bag& bag) const;
};

inline constexpr Parameter bag_extent{"extent", "m", 0, 100, true, "width or height of the bag", "a bag has an extent"};
inline constexpr Parameter strength_fraction_range{"strength_fraction",
                                                   "1",
                                                   0,
                                                   1,
                                                   true,
                                                   "of the strength where the bag fails",
                                                   "a hoop bears no more than its strength, and some"};
inline constexpr Parameter tolerance_range{"tolerance",
                                           "1",
                                           1e-10,
                                           1e-2,
                                           false,
                                           "relative error of surcharge and settlement",
                                           "below it rounding takes over, above it the result means little"};

/// What a response is computed from.
struct Case {
  Soil soil;
  Geotextile geotextile;
  Bag bag;
  LateralStress lateral;
  double strength_fraction = 0.5;            // of the strength where the bag counts as failed (thesis section 5.4)
  double tolerance = 1e-6;                   // relative, of surcharge and settlement
  std::optional<double> initial_settlement;  // compaction before the response begins, axial strain, 1
  std::optional<double> initial_surcharge;   // the same as a pressure, Pa
  std::optional<double> until;               // end at this surcharge, Pa, even if the bag carries more

  /// Hoop strain at the end: the fraction of strength over stiffness, at most the failure strain.
  double hoop_limit() const;
};

/// Bag, soil and geotextile at one surcharge. Strains are fractions, counted from the unloaded bag.
struct Point {
  double surcharge = 0, lateral = 0;  // outside, Pa
  double hoop_strain = 0, hoop_tension = 0;
  SoilState soil;  // strains in percent

  double settlement() const { return soil.strain_axial / 100; }
};

/// Throws DataError with all that is out of its range, and why: constants, bag, geotextile, fraction, tolerance,
/// lateral stress.
void check(const Case& what);

/// The whole response. Throws DataError where it cannot even begin: inadmissible constants at the first stress, a
/// compaction beyond the bag's capacity.
class Response {
 public:
  explicit Response(const Case& what);

  End end() const { return end_; }
  /// After compaction, if there is any.
  const Point& start() const { return start_; }
  /// Where the response ends: the ultimate state if end() is strength or failure_strain.
  const Point& last() const { return last_; }
  bool failed() const { return end_ != End::surcharge; }
  std::size_t steps() const { return path_.steps(); }

  /// The state at a surcharge between start() and last(), or at an axial strain (from the unloaded bag). Throws
  /// DataError with the range beyond them. Roots are bracketed (TOMS 748) to the last bits.
  Point at_surcharge(double surcharge) const;
  Point at_strain(double axial_strain) const;
  /// n+1 states, equal in settlement, from start() to `to` (a surcharge; default: the last).
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
