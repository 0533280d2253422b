// The inverse problem: the geotextile for a surcharge and settlement, and what a given bag carries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Demand on a bag.
struct Demand {
  /// Surcharge at service, Pa.
  double surcharge = 0;
  /// Greatest axial strain at the surcharge, from compaction; 1: any.
  double settlement = 1;
  /// Factor on the surcharge at which the hoops may reach their fraction of the strength.
  double safety = 1;
  /// Soil in the check of failure; empty: the bag's own.
  std::optional<Soil> weakened = {};
};

/// Range of stiffness to search.
struct StiffnessRange {
  /// Ends of the range, N/m.
  double low = 1e3, high = 1e8;
};

/// Limits that decide. range: the softest geotextile of the range will do. end: neither limit does, since the response
/// of the bag, or of one with a softer geotextile, ends before it.
enum class Governs { settlement, strength, range, end };

/// The answer to a demand.
struct Design {
  /// Softest geotextile that meets the demand, with its required strength.
  Geotextile geotextile;
  /// Limit that decides, and why a response ends before both (Governs::end).
  Governs governs = Governs::settlement;
  End end = End::none;
  /// States after compaction, at the surcharge, and at `safety` times it.
  Point start, service, factored;
};

/// Returns the geotextile with the smallest J that keeps eps_a(q) within the settlement. Roots are bracketed in ln J. A
/// given strength keeps its ratio to the stiffness and limits the hoops at `safety` times q. A failure strain alone
/// limits the hoops, too. Without either (0), the strength follows from the hoop tension at `safety` times q. All
/// tensions of a curve are scaled alike. `range` then holds its secant at the limit, and the result its secant at
/// service. Throws TargetNotReached if the stiffest geotextile is too soft, DataError for an inadmissible demand.
Design smallest_geotextile(const Case& bag, const Demand& demand, const StiffnessRange& range);

/// Surcharge that a given bag carries.
struct Allowance {
  /// Admissible surcharge, Pa.
  double surcharge = 0;
  /// Limit that decides, and why a response ends before both (Governs::end).
  Governs governs = Governs::strength;
  End end = End::none;
  /// State at the surcharge, and the state that limits it: at failure, or else the same.
  Point at, limit;
};
/// Returns the surcharge within the settlement, and with the safety against the capacity.
Allowance allowable_surcharge(const Case& bag, double settlement, double safety,
                              const std::optional<Soil>& weakened = std::nullopt);

/// One bag of a design chart. NaN: not reached.
struct ChartRow {
  Geotextile geotextile;
  /// Surcharge at which the response begins, Pa.
  double begins = 0;
  /// At the end of the response.
  double capacity = 0, settlement = 0, hoop_strain = 0;
  /// For the demand.
  double service_settlement = 0, allowable_surcharge = 0;
};
/// Returns n bags at equal steps of ln J. For a curve, J is the secant at the limit. Strength over stiffness and
/// failure strain stay constant.
std::vector<ChartRow> design_chart(const Case& bag, const Demand& demand, const StiffnessRange& range, std::size_t n);

}  // namespace soilweave::gws
