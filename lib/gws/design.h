// The inverse problem: which geotextile carries a surcharge within a settlement, and what a given bag carries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gws/respond.h"

namespace soilweave::gws {

/// What a bag has to bear. Settlement: axial strain at the surcharge, counted from compaction.
struct Demand {
  double surcharge = 0;   // Pa, at service
  double settlement = 1;  // admissible; 1: any
  double safety = 1;      // factor on the surcharge at which the hoops may reach their stated fraction of the strength
};

/// Stiffnesses to look between, N/m.
struct StiffnessRange {
  double low = 1e3, high = 1e8;
};

enum class Governs { settlement, strength, range };

struct Design {
  Geotextile geotextile;  // the softest that does, and the strength it needs
  Governs governs = Governs::settlement;
  Point start, service, factored;  // after compaction; at the surcharge; at safety times the surcharge
};

/// The smallest J with eps_a(q) within the settlement and, where the case's geotextile has a strength, that strength
/// over stiffness kept, hoops within their limit at safety times q: roots bracketed in ln J. Without (strength 0) the
/// strength follows from the hoop tension at safety times q. Throws TargetNotReached where the stiffest of the range
/// does not do, DataError for an inadmissible demand.
Design smallest_geotextile(const Case& bag, const Demand& demand, const StiffnessRange& range);

struct Allowance {
  double surcharge = 0;  // Pa
  Governs governs = Governs::strength;
  Point at;
};
/// The surcharge a bag carries within the settlement, and with the safety against its capacity.
Allowance allowable_surcharge(const Case& bag, double settlement, double safety);

/// One bag of a design chart; NaN for what it does not reach.
struct ChartRow {
  Geotextile geotextile;
  double capacity = 0, settlement = 0, hoop_strain = 0;    // at the end
  double service_settlement = 0, allowable_surcharge = 0;  // for the demand
};
/// n bags, equal in ln J over the range, of the case's geotextile: strength over stiffness and failure strain kept.
std::vector<ChartRow> design_chart(const Case& bag, const Demand& demand, const StiffnessRange& range, std::size_t n);

}  // namespace soilweave::gws
