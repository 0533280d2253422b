// The inverse problem.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/design/design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "gws/solution/root.h"
#include "gws/solution/secant.h"

namespace soilweave::gws {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr int tried_stiffnesses = 50;  // over the range, in equal ratios
// Share within which a limit counts as reached; the greatest tolerance of a response.
constexpr double reached = 0.01;
constexpr double unreached = std::numeric_limits<double>::quiet_NaN();

/// Returns the bag's geotextile with all tensions scaled to the stiffness J. For a curve, J is the secant at the bag's
/// limit.
Geotextile of_one_kind(const Case& bag, double J) {
  Geotextile found = bag.geotextile.layers(J / bag.geotextile.stiffness);
  found.name = bag.geotextile.name;
  return found;
}

/// Returns the kind of geotextile that a design looks for. With a failure strain alone, the stiffness is arbitrary (1
/// N/m) and the strength follows. Throws DataError if the numbers describe no kind.
Geotextile kind_of(Geotextile given) {
  const bool stiff = given.stiffness > 0, strong = given.strength > 0;
  if (!stiff && !strong && given.failure_strain > 0) {
    given.stiffness = 1;
    given.strength = given.failure_strain;
  } else if (stiff != strong) {
    throw DataError(
        fmt::format("geotextile {}: has a stiffness of {:.4g} N/m and a strength of {:.4g} N/m: a design takes both, "
                    "whose ratio stays, or neither",
                    given.name, given.stiffness, given.strength));
  }
  return given;
}

/// Returns the bag with stiffness J, loaded up to a surcharge. Its hoops have no limit but the end of their curve.
Case loaded_bag(Case bag, double J, double until) {
  bag.until = until;
  if (bag.geotextile.curve.known()) {
    bag.geotextile = of_one_kind(bag, J);
    return at_strain_reached(bag, until);
  }
  bag.geotextile.stiffness = J;
  bag.geotextile.strength = bag.geotextile.failure_strain = unlimited;
  return bag;
}

struct Trial {
  /// Whether the bag carries the surcharge, and the factored one.
  bool serves = false, bears = false;
  Point start, service, factored;
  /// Why the response ends that does not carry its surcharge.
  End end = End::none;
  /// Geotextile at service.
  Geotextile geotextile;
};

bool by_strength(End end) { return end == End::strength || end == End::failure_strain; }

Trial try_stiffness(const Case& bag, const Demand& demand, double J) {
  Case failing = bag;
  failing.soil = demand.weakened.value_or(bag.soil);
  const Response factored(loaded_bag(failing, J, demand.safety * demand.surcharge));
  // The factored surcharge uses the weaker soil, the surcharge at service the bag's own soil.
  const Case serving = loaded_bag(bag, J, demand.surcharge);
  const Response service(serving);
  return {!service.failed(), !factored.failed(), service.start(),
          service.last(),    factored.last(),    service.failed() ? service.end() : factored.end(),
          serving.geotextile};
}

/// Returns the smallest J of the range with excess(trial) <= 0, or infinity if there is none.
///
/// The excess falls with J wherever a solution exists. Under a very stiff geotextile some soils have no state at the
/// surcharge, so the search begins at the soft end of the range.
template <class Excess>
double smallest_stiffness(const Case& bag, const Demand& demand, const StiffnessRange& range, const Excess& excess) {
  bool begun = false;
  const auto f = [&](double x) {
    try {
      const Trial trial = try_stiffness(bag, demand, std::exp(x));
      begun = true;
      return excess(trial);
    } catch (const DataError&) {
      return 1.0;  // no state to begin with
    }
  };
  const double low = std::log(range.low), high = std::log(range.high);
  double before = low, f_before = f(low);
  if (f_before <= 0) return range.low;
  for (int i = 1; i <= tried_stiffnesses; ++i) {
    const double x = i == tried_stiffnesses ? high : low + (high - low) * i / tried_stiffnesses, f_x = f(x);
    if (f_x <= 0) {
      const auto close = [](double a, double b) { return std::abs(b - a) < 1e-10; };
      return std::exp(root_between(f, before, x, f_before, f_x, close).second);
    }
    before = x, f_before = f_x;
  }
  if (!begun) try_stiffness(bag, demand, range.high);  // throws, since the demand is impossible
  return unlimited;
}

/// Sets the limit that decides on the stiffness J of a design. Where that of the greater stiffness is not reached, a
/// softer geotextile carries no more up to it; the end of its response tells why.
void set_governing(Design& found, const Case& bag, const Demand& demand, double J, Governs greater, double limit) {
  const double settled = found.service.settlement() - found.start.settlement();
  found.governs = greater;
  if (greater == Governs::range || (greater == Governs::settlement && settled >= (1 - reached) * demand.settlement) ||
      (greater == Governs::strength && found.factored.hoop_strain >= (1 - reached) * limit))
    return;
  found.governs = Governs::end;
  try {
    found.end = try_stiffness(bag, demand, (1 - reached) * J).end;
    if (by_strength(found.end)) found.governs = Governs::strength;
    if (found.end == End::surcharge) found.governs = greater;  // rounding alone
  } catch (const DataError&) {
    const Soil weakest = demand.weakened.value_or(bag.soil);
    for (const Soil& soil : {weakest, bag.soil})
      if (const End end = soil_state(soil, soil.young_modulus((1 - reached) * J), soil.p_0, {}).end; end != End::none)
        found.end = end;
    // Hoops with a curve have a limit that the first state can exceed.
    if (found.end == End::none && bag.geotextile.curve.known()) found.governs = Governs::strength;
  }
}

/// Returns NaN in all columns if the bag is too soft to begin.
ChartRow chart_row(const Case& bag, const Demand& demand) {
  ChartRow row{bag.geotextile, unreached, unreached, unreached, unreached, unreached, unreached};
  try {
    const Answers answers(bag);
    const Response& response = answers.ultimate();
    row.begins = response.start().surcharge;
    row.capacity = response.last().surcharge;
    row.settlement = response.last().settlement() - response.start().settlement();
    row.hoop_strain = response.last().hoop_strain;
    if (answers.reaches(demand.surcharge)) row.service_settlement = answers.under(demand.surcharge).settlement();
    if (row.capacity / demand.safety > response.start().surcharge)
      row.allowable_surcharge = allowable_surcharge(bag, demand.settlement, demand.safety, demand.weakened).surcharge;
  } catch (const DataError&) {
    return row;
  }
  return row;
}

}  // namespace

Design smallest_geotextile(const Case& given, const Demand& demand, const StiffnessRange& range) {
  Case bag = given;
  if (!(demand.safety >= 1)) throw DataError("safety: must be at least 1");
  if (!(bag.strength_fraction > 0))
    throw DataError("strength_fraction: 0 leaves the geotextile nothing to hold; give a greater --strength-fraction");
  if (!(range.low > 0 && range.low < range.high))
    throw DataError("stiffness: the range must begin above 0 N/m and rise");
  bag.geotextile = kind_of(bag.geotextile);
  bag = at_strain_reached(bag, std::nullopt);
  const bool limited = bag.geotextile.strength > 0;
  const double limit = limited ? bag.hoop_limit() : unlimited, too_soft = 1;
  const double for_settlement = smallest_stiffness(bag, demand, range, [&](const Trial& t) {
    if (!t.serves || (!limited && !t.bears)) return too_soft;
    return t.service.settlement() - t.start.settlement() - demand.settlement;
  });
  const double for_strength =
      limited ? smallest_stiffness(bag, demand, range,
                                   [&](const Trial& t) { return t.bears ? t.factored.hoop_strain - limit : too_soft; })
              : range.low;
  const double J = std::max(for_settlement, for_strength);
  if (!std::isfinite(J))
    throw TargetNotReached(fmt::format(
        "no stiffness up to {:.4g} kN/m carries {:.6g} kPa {}; allow more, or take a higher limit", range.high / 1e3,
        demand.surcharge / 1e3,
        std::isfinite(for_settlement) ? fmt::format("with a safety of {:.4g} within the hoops' limit", demand.safety)
                                      : fmt::format("within a settlement of {:.4g} %", 100 * demand.settlement)));
  const Trial trial = try_stiffness(bag, demand, J);
  Design found{bag.geotextile, Governs::settlement, End::none, trial.start, trial.service, trial.factored};
  const Governs greater = J <= range.low                  ? Governs::range
                          : for_strength > for_settlement ? Governs::strength
                                                          : Governs::settlement;
  set_governing(found, bag, demand, J, greater, limit);
  found.geotextile.stiffness = J;
  if (bag.geotextile.curve.known()) {
    found.geotextile = trial.geotextile;
  } else if (limited) {
    found.geotextile = of_one_kind(bag, J);
  } else {
    found.geotextile.strength = std::max(0.0, trial.factored.hoop_tension) / bag.usable_share();
    found.geotextile.failure_strain = found.geotextile.strength / J;
  }
  return found;
}

Allowance allowable_surcharge(const Case& bag, double settlement, double safety, const std::optional<Soil>& weakened) {
  const Answers answers(bag);
  const Response& response = answers.ultimate();
  Case failing = bag;
  failing.soil = weakened.value_or(bag.soil);
  const Response weak = Answers(failing).ultimate();
  const Response& least = weak.last().surcharge < response.last().surcharge ? weak : response;
  Allowance found{least.last().surcharge / safety, Governs::strength, least.end(), {}, least.last()};
  if (!by_strength(found.end)) found.governs = Governs::end;
  if (found.surcharge < response.start().surcharge)
    throw DataError(fmt::format("safety {}: leaves {:.6g} Pa, below the initial surcharge {:.6g} Pa", safety,
                                found.surcharge, response.start().surcharge));
  if (settlement < response.last().settlement() - response.start().settlement()) {
    const Point at = answers.settled(settlement).at;
    if (at.surcharge < found.surcharge) found = {at.surcharge, Governs::settlement, End::none, {}, at};
  }
  found.at = answers.under(found.surcharge).at;
  return found;
}

std::vector<ChartRow> design_chart(const Case& given, const Demand& demand, const StiffnessRange& range,
                                   std::size_t n) {
  const Case bag = at_strain_reached(given, std::nullopt);
  check(bag);
  if (!(bag.geotextile.strength > 0)) throw DataError("chart: the geotextile needs a strength");
  std::vector<ChartRow> rows;
  for (std::size_t i = 0; i < n; ++i) {
    const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0;
    Case one = bag;
    one.until.reset();
    one.geotextile = of_one_kind(bag, range.low * std::pow(range.high / range.low, share));
    rows.push_back(chart_row(one, demand));
  }
  // Rows of too weak geotextiles have no values. If no row has values, this response throws the reason.
  if (std::ranges::all_of(rows, [](const ChartRow& row) { return std::isnan(row.capacity); })) {
    Case last = bag;
    last.until.reset(), last.geotextile = rows.back().geotextile;
    Response{last};
  }
  return rows;
}

}  // namespace soilweave::gws
