// Sensitivity of capacity and settlement to each constant, and bands from its scatter.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Effect of one number, varied alone. Settlements count from compaction. NaN: the varied bag has no response.
struct Sensitivity {
  std::string key, unit;
  /// Range: the 95 % interval if known, else `share` of the value.
  double value = 0, low = 0, high = 0;
  /// Whether the range is a 95 % interval.
  bool interval = false;
  /// Derivatives, Pa and 1 per unit of the number.
  double capacity_derivative = 0, settlement_derivative = 0;
  double capacity_low = 0, capacity_high = 0, settlement_low = 0, settlement_high = 0;
  /// Whether a surcharge was requested.
  bool asked = false;
  /// At that surcharge: settlement and hoop tension (N/m), per unit of the number.
  double service_settlement_derivative = 0, service_tension_derivative = 0;
  double service_settlement_low = 0, service_settlement_high = 0;
};

/// Returns the sensitivities by central differences at a thousandth of each value. The response runs to its end,
/// without bag.until. share: range over the value where no interval is known.
std::vector<Sensitivity> sensitivities(const Case& bag, const SoilFile& soil, double share);

/// Quantiles at 2.5, 50 and 97.5 %.
struct Band {
  double low = 0, middle = 0, high = 0;
};
/// Quantiles of the responses at one settlement.
struct BandRow {
  double settlement = 0;
  /// Number of responses that reach this settlement.
  std::size_t samples = 0;
  Band surcharge, axial_stress, radial_stress, hoop_strain;
};
/// Bands of responses, and of their ends.
struct Bands {
  /// Number of draws that have a response.
  std::size_t samples = 0;
  /// Number of draws without a response, by reason.
  std::map<std::string, std::size_t> left_out;
  /// Keys of the constants that were varied, and of those held because they have no scatter.
  std::vector<std::string> varied, held;
  Band capacity, settlement;
  std::vector<BandRow> rows;
};

/// Draws constants from their multivariate t distribution, and computes each response. Returns n+1 rows at equal steps
/// of settlement, from compaction to the end of the undisturbed response. Throws DataError if no constant has a
/// scatter, or no draw a response.
Bands monte_carlo(const Case& bag, const SoilFile& soil, std::int64_t samples, std::uint64_t seed, std::int64_t n);

/// Returns which constants were varied and which were held, in one phrase.
std::string variation(const Bands& bands);

}  // namespace soilweave::gws
