// Secants of a geotextile's curve.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/secant.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace soilweave::gws {
namespace {

double limit_strain(const Case& bag) {
  return std::min(bag.geotextile.curve.strain_at(bag.strength_fraction * bag.geotextile.strength),
                  bag.geotextile.failure_strain);
}

/// The state with this hoop strain, on the path that belongs to its own secant.
Point state_at(const Case& bag, double strain) {
  Case one = with_secant(bag, strain);
  one.until.reset();
  one.geotextile.failure_strain = strain;  // where the response shall end
  return Response(one).last();
}

}  // namespace

Case with_secant(Case bag, double strain) {
  bag.geotextile.stiffness = bag.geotextile.curve.tension_at(strain) / strain;
  bag.geotextile.secant_at = strain;
  return bag;
}

Case at_strain_reached(const Case& bag, std::optional<double> surcharge) {
  if (!bag.geotextile.curve.known()) return bag;
  const double limit = limit_strain(bag);
  if (!(limit > 0))
    throw DataError("strength_fraction: 0 leaves the geotextile nothing to hold; give a greater --strength-fraction");
  const Case at_limit = with_secant(bag, limit);
  if (!surcharge || state_at(bag, limit).surcharge <= *surcharge) return at_limit;
  const auto excess = [&](double log_strain) {
    try {
      return state_at(bag, std::exp(log_strain)).surcharge - *surcharge;
    } catch (const DataError&) {
      return -*surcharge;  // so small a strain that the first stress of the model is beyond it
    }
  };
  const double low = std::log(1e-4 * limit), high = std::log(limit);
  if (excess(low) >= 0) return with_secant(bag, std::exp(low));
  std::uintmax_t evaluations = std::numeric_limits<std::uintmax_t>::max();  // bisection ends it at the tolerance
  const auto close = [](double a, double b) { return std::abs(b - a) < 1e-9; };
  return with_secant(bag, std::exp(boost::math::tools::toms748_solve(excess, low, high, close, evaluations).second));
}

std::vector<Point> secant_points(const Case& bag, std::size_t n) {
  std::vector<Point> found{Response(bag).start()};
  for (std::size_t i = 1; i <= n; ++i) {
    const double strain = bag.geotextile.secant_at * static_cast<double>(i) / static_cast<double>(n);
    try {
      found.push_back(state_at(bag, strain));
    } catch (const DataError&) {
      continue;  // the bag has more tension at its beginning, compacted or not
    }
  }
  return found;
}

}  // namespace soilweave::gws
