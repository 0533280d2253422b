// Roots of functions between two ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/error.h"

namespace soilweave::gws {

/// Returns two ends that are `close` and between which f changes its sign, by TOMS 748. f_low and f_high, the values at
/// the first two ends, have different signs. Throws DataError where f is not finite, or if no two ends become close.
template <class Function, class Close>
std::pair<double, double> root_between(const Function& f, double low, double high, double f_low, double f_high,
                                       const Close& close) {
  // Bisection to the last bit takes about 60 evaluations, and TOMS 748 at most three times as many.
  constexpr std::uintmax_t most = 1000;
  const auto finite = [](double x, double value) {
    if (!std::isfinite(value))
      throw DataError(
          fmt::format("solution: is {} at {:.6g}, where a root is searched; correct the number of the bag, "
                      "soil or geotextile that is far from usual ones",
                      value, x));
    return value;
  };
  std::uintmax_t evaluations = most;
  const auto ends = boost::math::tools::toms748_solve([&](double x) { return finite(x, f(x)); }, low, high,
                                                      finite(low, f_low), finite(high, f_high), close, evaluations);
  if (evaluations >= most)
    throw DataError(
        fmt::format("solution: no root is found between {:.6g} and {:.6g}; correct the number of the bag, soil "
                    "or geotextile that is far from usual ones",
                    ends.first, ends.second));
  return ends;
}

}  // namespace soilweave::gws
