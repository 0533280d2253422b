// Sensitivity of capacity and settlement to each constant, and bands from the scatter of identified constants.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Effect of one constant, or of one number of bag or geotextile, varied alone. Settlements count from compaction. NaN
/// if the varied bag has no response.
struct Sensitivity {
  std::string key, unit;
  double value = 0, low = 0, high = 0;  // range: the 95 % interval if known, else `share` of the value
  bool interval = false;
  double capacity_derivative = 0, settlement_derivative = 0;  // Pa and 1, per unit of the constant
  double capacity_low = 0, capacity_high = 0, settlement_low = 0, settlement_high = 0;
  bool asked = false;  // a surcharge was asked for; at it, settlement and hoop tension (N/m) per unit of the constant
  double service_settlement_derivative = 0, service_tension_derivative = 0;
  double service_settlement_low = 0, service_settlement_high = 0;
};

/// Returns the sensitivities by central differences at a thousandth of each value. The response runs to its end,
/// whatever bag.until says. `share`: range as a share of the value, if no interval is known.
std::vector<Sensitivity> sensitivities(const Case& bag, const SoilFile& soil, double share);

/// Quantiles at 2.5, 50 and 97.5 %.
struct Band {
  double low = 0, middle = 0, high = 0;
};
/// One row of the bands: quantiles of the responses at one settlement.
struct BandRow {
  double settlement = 0;
  std::size_t samples = 0;  // number of responses that get as far
  Band surcharge, axial_stress, radial_stress, hoop_strain;
};
/// Bands of responses, and of their ends.
struct Bands {
  std::int64_t samples = 0;
  std::map<std::string, std::size_t> left_out;  // number of draws without a response, by reason
  Band capacity, settlement;
  std::vector<BandRow> rows;
};

/// Draws the constants that have a scatter from its multivariate t distribution, and computes the response of each
/// draw. Rows stand at n+1 equal steps of settlement up to the end of the response with the constants as given. Throws
/// DataError if no constant has a scatter, or if no draw has a response.
Bands monte_carlo(const Case& bag, const SoilFile& soil, std::int64_t samples, std::uint64_t seed, std::int64_t n);

}  // namespace soilweave::gws
