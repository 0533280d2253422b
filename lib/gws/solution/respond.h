// The response of a bag to surcharge (thesis section 5.3.4), up to its ultimate bearing capacity.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bag of width B and height H lies under a surcharge sigma_as. It flattens and spreads, which stretches the
// geotextile. The hoop tension t_h presses the soil together from all sides, so the soil inside carries more than the
// load outside. Balance of forces on half the bag, with strains eps_a and eps_r of the soil:
//
//   vertical  sigma_as = sigma_a - 4 t_h / [B (1 - eps_r)^2]
//   lateral   2 (B + H) t_h = (sigma_r - sigma_rs) B H (1 - eps_a)(1 - eps_r)
//
// Eliminating t_h gives Eq. 5.3; the hoop strain is eps_h = t_h / J (Eq. 5.16).
//
// The soil's own path (path.h) gives stresses and strains as functions of its mean stress p alone. At each state the
// balance gives the surcharge and the hoop strain. A response walks up the path until the hoops reach their stated
// fraction of the strength: there sigma_as is the ultimate bearing capacity. It ends earlier if the soil fails or the
// requested surcharge is reached (enum End).
//
// Compaction is a first stretch of the path, whose strains remain. Soil around the bag gives a lateral stress sigma_rs.
//
//   const Response response({.soil = soil, .geotextile = geotextile, .bag = {0.4, 0.08}});
//   const Point ultimate = response.last();          // surcharge, strains, hoop tension
//   const Point service = response.at_surcharge(500e3);
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gws/solution/geotextile.h"
#include "gws/solution/path.h"

namespace soilweave::gws {

/// Lateral stress sigma_rs outside the bag by surcharge: linear between points, constant beyond.
struct LateralStress {
  /// Points, Pa; empty: no lateral stress. The name stands in messages, with the points' file.
  std::vector<double> surcharge, lateral;
  std::string name = "lateral stress";

  /// Returns a constant lateral stress, Pa.
  static LateralStress constant(double stress) { return {{0}, {stress}}; }
  /// Returns the lateral stress at a surcharge, Pa.
  double at(double surcharge) const;
  /// Throws DataError if surcharges fall (the model cannot unload), if a stress is negative, or if d lateral / d
  /// surcharge reaches (1 + H/B)/(2 H/B). There the lateral stress alone carries the undeformed bag's surcharge.
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
  /// Fraction of the strength at which the bag fails (thesis section 5.4).
  double strength_fraction = 0.5;
  /// Factor that divides the strength in the long term. `geotextile` has the strength before reduction.
  double reduction = 1;
  /// Relative error of surcharge and settlement.
  double tolerance = 1e-6;
  /// Axial strain of compaction before the response, 1.
  std::optional<double> initial_settlement;
  /// Compaction as a pressure, Pa.
  std::optional<double> initial_surcharge;
  /// Surcharge at which to end, Pa, even below the capacity.
  std::optional<double> until;

  /// Returns the share of the strength before reduction at which the bag fails.
  double usable_share() const { return strength_fraction / reduction; }
  /// Returns the hoop strain at the end: usable_share() times strength over stiffness, or the lesser failure strain.
  double hoop_limit() const;
};

/// Bag, soil and geotextile at one surcharge. Strains are fractions, from the unloaded bag.
struct Point {
  /// Outside the bag, Pa.
  double surcharge = 0, lateral = 0;
  /// Strain, 1; tension, N/m.
  double hoop_strain = 0, hoop_tension = 0;
  /// Its strains are in percent.
  SoilState soil;

  /// Returns the axial strain as a fraction.
  double settlement() const { return soil.strain_axial / 100; }
};

/// Throws DataError naming all values out of range.
void check(const Case& what);

/// The whole response. The constructor throws DataError for constants inadmissible at the first stress, for a lateral
/// stress under which the hoops are never stretched, or for compaction beyond the bag's capacity.
class Response {
 public:
  /// Computes it from the first state to the end.
  explicit Response(const Case& what);

  /// Returns why the response ended.
  End end() const { return end_; }
  /// Returns the state after compaction, or the first one.
  const Point& start() const { return start_; }
  /// Returns the last state, ultimate if end() is strength or failure_strain.
  const Point& last() const { return last_; }
  /// Returns whether the bag failed below the requested surcharge.
  bool failed() const { return end_ != End::surcharge; }
  /// Returns the number of steps along the path.
  std::size_t steps() const { return path_.steps(); }

  /// Return the state at a surcharge, or at an axial strain of the unloaded bag. They throw DataError beyond the range.
  Point at_surcharge(double surcharge) const;
  Point at_strain(double axial_strain) const;
  /// Returns n+1 states at equal steps of settlement, from start() to surcharge `to` (default: the last).
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
