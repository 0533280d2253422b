// Doubts about the tables of runs that are compared with observations.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/run_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "files/provenance.h"

namespace soilweave::calibration {
namespace {

constexpr double widest_share = 0.2;
// Tables may give parameters in two or three digits.
constexpr double rounding_of_tables = 0.01;
// Fewer rows may be equal by rounding alone.
constexpr std::size_t fewest_rows = 3;
constexpr std::size_t listed = 3;

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
  compare_rows(run, id, member);
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

void OtherSets::compare_rows(const io::Series& run, std::int64_t id, std::size_t member) {
  if (run.rows() < fewest_rows) return;
  std::string numbers;
  for (const std::string& name : compared_)
    if (const io::Column* column = run.find(name)) numbers += fmt::format("{} ", fmt::join(column->values, " "));
  const auto [known, added] = first_.try_emplace(io::sha256(numbers), id, member);
  const std::size_t first = known->second.second;
  const auto differs = [&](const io::Column& set) { return set.values[member] != set.values[first]; };
  if (!added && std::ranges::any_of(sets_.columns, differs))
    equal_.push_back(fmt::format("{} as {}", id, known->second.first));
}

void OtherSets::doubt(std::vector<Doubt>& doubts) const {
  if (runs_ > 0)
    doubts.push_back(
        {"other_sets", fmt::format("{} {} other parameters than the sets of their ids have, as {}; give the ensemble "
                                   "that these runs were made with",
                                   runs_, runs_ == 1 ? "run names" : "runs name", example_)});
  const std::size_t more = equal_.size() - std::min(equal_.size(), listed);
  if (!equal_.empty())
    doubts.push_back(
        {"equal_runs", fmt::format("members of other parameters have equal runs, and each is weighted: {}{}; give each "
                                   "its own run, unless its parameters change nothing that the runs are compared by",
                                   fmt::join(std::span(equal_).first(equal_.size() - more), ", "),
                                   more > 0 ? fmt::format(", and {} more", more) : "")});
}

MixedRuns::MixedRuns(const Observations& observed, const Choice& choice) {
  if (choice.greatest) progress_ = {"step", "time", observed.station.columns.front(), "strain_axial"};
}

void MixedRuns::compare(const io::Series& run, std::int64_t id) {
  const auto known = std::ranges::find_if(progress_, [&](const std::string& name) { return run.find(name); });
  if (known == progress_.end()) {
    if (!progress_.empty()) rows_[id] = run.rows();
    return;
  }
  const std::vector<double>& values = run.at(*known).values;
  double greatest = values.front();
  for (std::size_t r = 1; r < values.size(); ++r) {
    if (greatest - values[r] > (greatest - values.front()) / 2) {
      begun_again_.push_back(fmt::format("member {}, whose {} falls from {:.6g} to {:.6g} in row {}", id, *known,
                                         values[r - 1], values[r], r + 1));
      return;
    }
    greatest = std::max(greatest, values[r]);
  }
}

void MixedRuns::doubt(std::vector<Doubt>& doubts) const {
  std::vector<std::string> all = begun_again_;
  std::map<std::size_t, std::size_t> members;
  for (const auto& [id, rows] : rows_) ++members[rows];
  const auto usual = std::ranges::max_element(members, {}, [](const auto& one) { return one.second; });
  for (const auto& [id, rows] : rows_)
    if (2 * usual->second > rows_.size() && rows > usual->first && rows % usual->first == 0)
      all.push_back(fmt::format("member {}, which has {} rows where most have {}", id, rows, usual->first));
  if (all.empty()) return;
  doubts.push_back(
      {"mixed", fmt::format("the greatest values may be those of several runs under one id: {}{}; give "
                            "each run its own id, or choose rows with --where",
                            all.front(), all.size() > 1 ? fmt::format(", and {} more", all.size() - 1) : "")});
}

}  // namespace soilweave::calibration
