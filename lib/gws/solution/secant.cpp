// Secants of a geotextile's curve.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/secant.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "gws/solution/root.h"

namespace soilweave::gws {
namespace {

/// Returns the response up to this hoop strain, with the secant stiffness at this strain.
Response response_to(const Case& bag, double strain) {
  Case one = with_secant(bag, strain);
  one.until.reset();
  one.geotextile.failure_strain = strain;  // the response ends there
  return Response(one);
}

/// Returns the bag with the secant at the hoop strain where value(response) reaches `wanted`, or at the limit if it
/// stays below. The value must rise with the strain.
template <class Value>
Case where(const Case& bag, double wanted, const Value& value) {
  const double limit = limit_strain(bag);
  const auto excess = [&](double log_strain) {
    try {
      return value(response_to(bag, std::exp(log_strain))) - wanted;
    } catch (const DataError&) {
      return -1.0;  // the first stress of the model, or the compaction, already strains the hoops more
    }
  };
  const double low = std::log(1e-4 * limit), high = std::log(limit);
  const double at_high = excess(high), at_low = excess(low);
  if (at_high <= 0) return with_secant(bag, limit);
  if (at_low >= 0) return with_secant(bag, std::exp(low));
  const auto close = [](double a, double b) { return std::abs(b - a) < 1e-9; };
  return with_secant(bag, std::exp(root_between(excess, low, high, at_low, at_high, close).second));
}

double end_of(const Response& response) { return response.last().surcharge; }
double settlement_of(const Response& response) { return response.last().settlement() - response.start().settlement(); }

/// Returns the bag without `until`, with the secant at its limit.
Case to_its_limit(Case bag) {
  bag.until.reset();
  return at_strain_reached(bag, std::nullopt);
}

}  // namespace

double limit_strain(const Case& bag) {
  return std::min(bag.geotextile.curve.strain_at(bag.usable_share() * bag.geotextile.strength),
                  bag.geotextile.failure_strain);
}

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
  if (!surcharge) return with_secant(bag, limit);
  return where(bag, *surcharge, end_of);
}

Answers::Answers(const Case& bag) : bag_(to_its_limit(bag)), ultimate_(bag_) {}

bool Answers::reaches(double surcharge) const {
  return surcharge >= ultimate_.start().surcharge && surcharge <= ultimate_.last().surcharge;
}

Answers::Answer Answers::under(double surcharge) const {
  if (!bag_.geotextile.curve.known() || !reaches(surcharge))
    return {ultimate_.start(), ultimate_.at_surcharge(surcharge)};
  const Response response(at_strain_reached(bag_, surcharge));
  // The search for the secant may end a rounding short of the surcharge.
  return {response.start(), response.at_surcharge(std::min(surcharge, response.last().surcharge))};
}

Answers::Answer Answers::settled(double settlement) const {
  if (!bag_.geotextile.curve.known() || settlement >= settlement_of(ultimate_))
    return {ultimate_.start(), ultimate_.at_strain(ultimate_.start().settlement() + settlement)};
  const Response response(where(bag_, settlement, settlement_of));
  const double strain = response.start().settlement() + settlement;
  return {response.start(), response.at_strain(std::min(strain, response.last().settlement()))};
}

std::vector<Point> secant_points(const Case& bag, std::size_t n) {
  std::vector<Point> found{Response(bag).start()};
  for (std::size_t i = 1; i <= n; ++i) {
    const double strain = bag.geotextile.secant_at * static_cast<double>(i) / static_cast<double>(n);
    try {
      found.push_back(response_to(bag, strain).last());
    } catch (const DataError&) {
      continue;  // the first state, compacted or not, already has more tension
    }
  }
  return found;
}

}  // namespace soilweave::gws
