// Doubts about the tables of runs that are compared with observations.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/run_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soilweave::calibration {
namespace {

constexpr double widest_share = 0.2;
// Tables may give parameters in two or three digits.
constexpr double rounding_of_tables = 0.01;

}  // namespace

void WidestGap::compare(const std::vector<double>& rows, std::int64_t id) {
  const double slack = observed_.rounding();
  for (const double at : observed_.at) {
    const auto next = std::lower_bound(rows.begin(), rows.end(), at - slack);
    if (next == rows.begin() || next == rows.end() || *next <= at + slack) continue;
    if (*next - *(next - 1) > to_ - from_) id_ = id, from_ = *(next - 1), to_ = *next, station_ = at;
  }
}

void WidestGap::doubt(std::vector<Doubt>& doubts) const {
  const double first = observed_.at.front(), last = observed_.at.back();
  const double range = std::max({std::abs(first), std::abs(last), last - first});
  if (!(to_ - from_ > widest_share * range)) return;
  doubts.push_back(
      {"coarse", fmt::format("the run of member {0} has no row between {1} {2:.6g} and {3:.6g}, and counts as a "
                             "straight line there, where {1} {4:.6g} is observed; give runs with rows near the "
                             "stations of the observations, or check the unit of {1} in both tables",
                             id_, observed_.station.name, from_, to_, station_)});
}

OtherSets::OtherSets(const io::Series& sets, const Observations& observed, const Choice& choice) : sets_(sets) {
  compared_ = observed.station.columns;
  for (const Observable& what : observed.observables)
    compared_.insert(compared_.end(), what.columns.begin(), what.columns.end());
  for (const auto& [name, value] : choice.where) compared_.push_back(name);
}

void OtherSets::compare(const io::Series& run, std::int64_t id, std::size_t member) {
  for (const io::Column& set : sets_.columns) {
    const io::Column* own = run.find(set.name);
    if (!own || own->values.empty() || std::ranges::count(compared_, set.name) > 0) continue;
    if (own->unit != set.unit && !(own->unit.empty() && set.unit == "1")) continue;
    const auto [least, most] = std::minmax_element(own->values.begin(), own->values.end());
    const double value = own->values.front(), wanted = set.values[member];
    if (*least != *most || std::abs(value - wanted) <= rounding_of_tables * std::abs(wanted)) continue;
    if (runs_++ == 0)
      example_ =
          fmt::format("member {}, whose {} is {:.6g} in its run and {:.6g} in its set", id, set.name, value, wanted);
    return;
  }
}

void OtherSets::doubt(std::vector<Doubt>& doubts) const {
  if (runs_ > 0)
    doubts.push_back(
        {"other_sets", fmt::format("{} {} other parameters than the sets of their ids have, as {}; give the ensemble "
                                   "that these runs were made with",
                                   runs_, runs_ == 1 ? "run names" : "runs name", example_)});
}

}  // namespace soilweave::calibration
