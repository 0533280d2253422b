// How much capacity and settlement hang on each constant, and the bands that the scatter of identified constants
// leaves. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gws/respond.h"

namespace soilweave::gws {

/// One constant, or one number of bag and geotextile, varied alone. Settlements since compaction; NaN where the varied
/// bag has no response.
struct Sensitivity {
  std::string key, unit;
  double value = 0, low = 0, high = 0;  // the range: the 95 % interval where one is known, else the share asked for
  bool interval = false;
  double capacity_derivative = 0, settlement_derivative = 0;  // Pa and 1, per unit of the constant
  double capacity_low = 0, capacity_high = 0, settlement_low = 0, settlement_high = 0;
};

/// The response goes on to its end, whatever bag.until says. Central differences at a thousandth of each value. share:
/// of the value, where no interval is known.
std::vector<Sensitivity> sensitivities(const Case& bag, const SoilFile& soil, double share);

/// Quantiles of 2.5, 50 and 97.5 %.
struct Band {
  double low = 0, middle = 0, high = 0;
};
struct BandRow {
  double settlement = 0;
  std::size_t samples = 0;  // that get as far
  Band surcharge, axial_stress, radial_stress, hoop_strain;
};
struct Bands {
  std::int64_t samples = 0;
  std::map<std::string, std::size_t> left_out;  // draws without a response, by reason
  Band capacity, settlement;
  std::vector<BandRow> rows;
};

/// Draws the constants that have a scatter from its multivariate t distribution, and answers every draw. The rows stand
/// at n+1 equal steps of settlement up to the end of the undisturbed response. Throws DataError where no constant has a
/// scatter, or none of the draws has a response.
Bands monte_carlo(const Case& bag, const SoilFile& soil, std::int64_t samples, std::uint64_t seed, std::int64_t n);

}  // namespace soilweave::gws
