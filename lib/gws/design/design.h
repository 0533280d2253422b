// The inverse problem: which geotextile carries a surcharge within a settlement, and what a given bag carries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Demand on a bag. The settlement is the axial strain at the surcharge, counted from compaction.
struct Demand {
  double surcharge = 0;   // surcharge at service, Pa
  double settlement = 1;  // greatest admissible settlement; 1: any
  double safety = 1;      // factor on the surcharge at which the hoops may reach their stated fraction of the strength
  std::optional<Soil> weakened = {};  // soil in the check of failure; empty: the bag's own
};

/// Range of stiffness to search, N/m.
struct StiffnessRange {
  double low = 1e3, high = 1e8;
};

enum class Governs { settlement, strength, range };

/// The answer to a demand.
struct Design {
  Geotextile geotextile;  // softest geotextile that meets the demand, with the strength it needs
  Governs governs = Governs::settlement;
  Point start, service, factored;  // states after compaction, at the surcharge, and at `safety` times the surcharge
};

/// Returns the geotextile with the smallest J that keeps eps_a(q) within the settlement. Roots are bracketed in ln J.
/// If the case's geotextile has a strength, the ratio of strength to stiffness is kept, and the hoops stay within their
/// limit at `safety` times q. If it has none (0), the strength follows from the hoop tension at `safety` times q.
/// Throws TargetNotReached if the stiffest geotextile of the range is too soft, DataError for an inadmissible demand.
Design smallest_geotextile(const Case& bag, const Demand& demand, const StiffnessRange& range);

/// Surcharge that a given bag carries.
struct Allowance {
  double surcharge = 0;  // Pa
  Governs governs = Governs::strength;
  Point at;
};
/// Returns the surcharge that a bag carries within the settlement, and with the safety against its capacity.
Allowance allowable_surcharge(const Case& bag, double settlement, double safety,
                              const std::optional<Soil>& weakened = std::nullopt);

/// One bag of a design chart. A NaN marks what the bag does not reach.
struct ChartRow {
  Geotextile geotextile;
  double capacity = 0, settlement = 0, hoop_strain = 0;    // values at the end of the response
  double service_settlement = 0, allowable_surcharge = 0;  // values for the demand
};
/// Returns n bags with stiffnesses at equal steps of ln J. They keep the geotextile's strength over stiffness and
/// failure strain.
std::vector<ChartRow> design_chart(const Case& bag, const Demand& demand, const StiffnessRange& range, std::size_t n);

}  // namespace soilweave::gws
