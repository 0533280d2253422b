// The response of a bag to surcharge.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/respond.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/error.h"
#include "core/text/text.h"
#include "gws/solution/root.h"

namespace soilweave::gws {
namespace {

constexpr Parameter reduction_range{
    "reduction", "1", 1, 1e6, false, "divides the strength in the long term", "below 1 it would take away safety"};

/// Returns the surcharge that balances the state, and the lateral stress at that surcharge. Eq. 5.3 is linear on each
/// straight piece of the lateral stress. LateralStress::check() ensures that 1 - share * slope stays positive.
std::pair<double, double> balance(const Bag& bag, const SoilState& state, const LateralStress& lateral) {
  if (lateral.surcharge.empty()) return {surcharge(bag, state, 0), 0};
  const double share = 2 * hoop_share(bag, state);
  const std::vector<double>&s = lateral.surcharge, &r = lateral.lateral;
  const auto solve = [&](std::size_t i, double slope) {
    return (surcharge(bag, state, 0) + share * (r[i] - slope * s[i])) / (1 - share * slope);
  };
  double load = solve(0, 0);
  for (std::size_t i = 0; i < s.size() && load > s[i]; ++i) {
    if (i + 1 == s.size()) {
      load = solve(i, 0);
    } else if (s[i + 1] > s[i]) {
      load = solve(i, (r[i + 1] - r[i]) / (s[i + 1] - s[i]));
      if (load <= s[i + 1]) break;
    }
  }
  return {load, lateral.at(load)};
}

}  // namespace

double LateralStress::at(double load) const {
  if (surcharge.empty()) return 0;
  const auto after = std::upper_bound(surcharge.begin(), surcharge.end(), load);
  if (after == surcharge.begin()) return lateral.front();
  if (after == surcharge.end()) return lateral.back();
  const auto i = static_cast<std::size_t>(after - surcharge.begin()) - 1;
  return lateral[i] + (lateral[i + 1] - lateral[i]) * (load - surcharge[i]) / (surcharge[i + 1] - surcharge[i]);
}

void LateralStress::check(const Bag& bag) const {
  const double slenderness = bag.height / bag.width, steepest = (1 + slenderness) / (2 * slenderness);
  if (surcharge.size() != lateral.size()) throw DataError(name + ": as many stresses as surcharges are needed");
  for (std::size_t i = 0; i < surcharge.size(); ++i) {
    if (!(lateral[i] >= 0) || !(surcharge[i] >= 0))
      throw DataError(
          fmt::format("{}: row {}: {} Pa at a surcharge of {} Pa; both must be at least 0 Pa, compression: correct it",
                      name, i + 1, lateral[i], surcharge[i]));
    if (i == 0) continue;
    if (!(surcharge[i] > surcharge[i - 1]))
      throw DataError(fmt::format(
          "{}: row {}: the surcharge {} Pa is not above the one before; the model cannot unload: give rows that rise",
          name, i + 1, surcharge[i]));
    const double slope = (lateral[i] - lateral[i - 1]) / (surcharge[i] - surcharge[i - 1]);
    if (!(slope < steepest))
      throw DataError(
          fmt::format("{}: row {}: it rises {:.3g} times as fast as the surcharge; must be below {:.3g}, or "
                      "the bag is loaded from its sides: check the units of both columns",
                      name, i + 1, slope, steepest));
  }
}

void check(const Case& what) {
  std::string wrong;
  const auto judge = [&](double value, const std::string& name, const Parameter& range) {
    if (range.contains(value)) return;
    wrong += fmt::format("{}{}: {} is out of range: must be {} ({})", wrong.empty() ? "" : "\n", name,
                         number_text(value), range_text(range), range.why);
  };
  for (const Constant& c : constants()) judge(what.soil.*c.field, c.key(), c.parameter);
  judge(what.bag.width, "width", bag_extent);
  judge(what.bag.height, "height", bag_extent);
  judge(what.geotextile.stiffness, "stiffness", tensile_stiffness);
  if (!(what.geotextile.strength > 0) || !(what.geotextile.failure_strain > 0))
    judge(std::min(what.geotextile.strength, what.geotextile.failure_strain), "strength and failure strain",
          tensile_strength);
  judge(what.strength_fraction, "strength_fraction", strength_fraction_range);
  judge(what.reduction, "reduction", reduction_range);
  judge(what.tolerance, "tolerance", tolerance_range);
  if (what.initial_settlement && what.initial_surcharge)
    wrong += "compaction: give an initial settlement or an initial surcharge, not both";
  if (!wrong.empty()) throw DataError(wrong);
  what.lateral.check(what.bag);
}

double Case::hoop_limit() const {
  return std::min(usable_share() * geotextile.strength / geotextile.stiffness, geotextile.failure_strain);
}

Response::Response(const Case& what)
    : case_((check(what), what)), path_(what.soil, what.soil.young_modulus(what.geotextile.stiffness), what.tolerance) {
  if (path_.end() != End::none)
    throw DataError(fmt::format("soil: its constants allow no state at the first mean stress, {} Pa: {}", what.soil.p_0,
                                reason(path_.end())));
  begin_ = finish_ = path_.first();
  start_ = last_ = point(begin_);
  if (last_.hoop_strain >= case_.hoop_limit())
    throw DataError(
        fmt::format("geotextile {}: fails under the first stress of the model already, at a hoop strain of {:.3g}; "
                    "take a stronger one, or a greater --strength-fraction",
                    what.geotextile.name, last_.hoop_strain));
  if (case_.until && *case_.until < start_.surcharge)
    throw DataError(fmt::format(
        "surcharge: {} Pa is below the initial one, {:.6g} Pa (mean stress {} Pa); the model has no state there",
        *case_.until, start_.surcharge, what.soil.p_0));
  march();
  if (failed() && last_.hoop_tension < 0)
    throw DataError(
        fmt::format("{}: {:.6g} kPa outside the bag exceed the soil's own, {:.4g} kPa, where the response ends "
                    "({}): the geotextile is never stretched; take a smaller lateral stress",
                    case_.lateral.name, last_.lateral / 1e3, last_.soil.lateral_stress() / 1e3, reason(end_)));
  compact();
}

Point Response::point(double x) const {
  Point at;
  at.soil = path_.at(x);
  std::tie(at.surcharge, at.lateral) = balance(case_.bag, at.soil, case_.lateral);
  at.hoop_tension = hoop_tension(case_.bag, at.soil, at.lateral);
  at.hoop_strain = at.hoop_tension / case_.geotextile.stiffness;
  return at;
}

/// Returns ln p where value(point) is zero; the signs at the ends must differ.
template <class Value>
double Response::root(double low, double high, const Value& value) const {
  const auto f = [&](double x) { return value(point(x)); };
  const double f_low = f(low), f_high = f(high);
  // Rounding at the end of the response can leave both ends with one sign.
  if (f_low == 0 || (f_low > 0) == (f_high > 0)) return std::abs(f_low) < std::abs(f_high) ? low : high;
  if (f_high == 0) return high;
  const auto [a, b] = root_between(f, low, high, f_low, f_high, boost::math::tools::eps_tolerance<double>());
  return std::abs(f(a)) < std::abs(f(b)) ? a : b;
}

void Response::march() {
  const double limit = case_.hoop_limit();
  while (end_ == End::none) {
    const Point before = last_;
    if (!path_.advance()) {
      end_ = path_.end();
      return;
    }
    Point now = point(path_.last());
    double x = path_.last();
    const auto cut = [&](End why, const auto& value) {
      x = root(finish_, x, value);
      now = point(x);
      end_ = why;
    };
    if (now.hoop_strain >= limit)
      cut(limit < case_.geotextile.failure_strain ? End::strength : End::failure_strain,
          [&](const Point& p) { return p.hoop_strain - limit; });
    if (case_.until && now.surcharge >= *case_.until) {
      cut(End::surcharge, [&](const Point& p) { return p.surcharge - *case_.until; });
      now.surcharge = *case_.until;  // equal but for rounding
    }
    if (!(now.surcharge > before.surcharge)) {
      end_ = End::softening;
      return;
    }
    last_ = now;
    finish_ = x;
  }
}

void Response::compact() {
  if (case_.initial_settlement) {
    if (*case_.initial_settlement >= last_.settlement())
      throw DataError(fmt::format("initial settlement: {} is not below the {:.4g} at which the response ends: {}",
                                  *case_.initial_settlement, last_.settlement(), reason(end_)));
    start_ = at_strain(*case_.initial_settlement);
  } else if (case_.initial_surcharge) {
    if (*case_.initial_surcharge < start_.surcharge || *case_.initial_surcharge >= last_.surcharge)
      throw DataError(
          fmt::format("initial surcharge: {} Pa is not from {:.6g} Pa, where the model begins, to {:.6g} Pa, where the "
                      "response ends: {}",
                      *case_.initial_surcharge, start_.surcharge, last_.surcharge, reason(end_)));
    start_ = at_surcharge(*case_.initial_surcharge);
  }
  begin_ = std::log(start_.soil.p);
}

Point Response::at_surcharge(double load) const {
  if (!(load >= start_.surcharge && load <= last_.surcharge))
    throw DataError(
        fmt::format("surcharge: {} Pa is not from the initial {:.6g} Pa to {:.6g} Pa, where the response ends: {}",
                    load, start_.surcharge, last_.surcharge, reason(end_)));
  return point(root(begin_, finish_, [&](const Point& p) { return p.surcharge - load; }));
}

Point Response::at_strain(double axial_strain) const {
  if (!(axial_strain >= start_.settlement() && axial_strain <= last_.settlement()))
    throw DataError(fmt::format("settlement: {} is not from {:.4g} to {:.4g}, where the response ends: {}",
                                axial_strain, start_.settlement(), last_.settlement(), reason(end_)));
  return point(root(begin_, finish_, [&](const Point& p) { return p.settlement() - axial_strain; }));
}

std::vector<Point> Response::points(std::size_t n, std::optional<double> to) const {
  const Point end = to && *to < last_.surcharge ? at_surcharge(*to) : last_;
  std::vector<Point> found{start_};
  for (std::size_t i = 1; i < n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    found.push_back(at_strain(start_.settlement() + share * (end.settlement() - start_.settlement())));
  }
  found.push_back(end);
  return found;
}

}  // namespace soilweave::gws
