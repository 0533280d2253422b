// Converts ensembles to and from tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/error.h"
#include "core/text/text.h"
#include "files/exchange/table.h"
#include "store/bytes.h"

namespace soilweave::calibration {
namespace {

constexpr const char* importance_name = "log_importance";
constexpr const char* weight_name = "weight";
constexpr const char* rounds_name = "rounds";

std::vector<double> column_of(const Vector& values) { return {values.data(), values.data() + values.size()}; }

Vector vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

io::Series table_of(const Ensemble& e, bool importance) {
  io::Series table;
  const std::vector<double> id(e.id.begin(), e.id.end());
  table.columns.push_back({"id", "1", "number that stays with the parameter set and names its run", id});
  for (io::Column& column : e.parameters().columns) table.columns.push_back(std::move(column));
  if (importance)
    table.columns.push_back(
        {importance_name, "1", "log of the prior density over the density drawn from", column_of(e.log_importance)});
  if (e.weight.size() > 0) table.columns.push_back({weight_name, "1", "posterior weight", column_of(e.weight)});
  return table;
}

/// Returns a column that may be missing.
Vector optional_column(const io::Series& table, const char* name, Eigen::Index rows, const std::string& where) {
  const io::Column* column = table.find(name);
  if (column == nullptr) return name == weight_name ? Vector() : Vector(Vector::Zero(rows));
  for (const double v : column->values)
    if (!std::isfinite(v))
      throw DataError(fmt::format("{}: {}: holds {}; every member needs a finite number", where, name, v));
  return vector_of(column->values);
}

/// Returns the weights; empty if the ensemble has none yet.
Vector read_weights(const io::Series& table, Eigen::Index rows, const std::string& where) {
  const Vector weight = optional_column(table, weight_name, rows, where);
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    if (weight[i] < 0)
      throw DataError(
          fmt::format("{}: {}: row {}: {} is negative; weights are 0 or more", where, weight_name, i + 1, weight[i]));
  return weight;
}

std::vector<std::int64_t> read_ids(const io::Series& table, const std::string& where) {
  std::vector<std::int64_t> ids;
  std::set<double> seen;
  for (const double v : table.at("id").values) {
    if (v != std::nearbyint(v) || std::abs(v) > 9e15)
      throw DataError(fmt::format("{}: row {}: id {} is no whole number", where, ids.size() + 1, v));
    if (!seen.insert(v).second)
      throw DataError(fmt::format("{}: row {}: id {} is there twice", where, ids.size() + 1, v));
    ids.push_back(static_cast<std::int64_t>(v));
  }
  if (ids.empty()) throw DataError(where + ": has no members; draw some first");
  return ids;
}

// Share of the range by which a set may lie outside, since logarithms are rounded.
constexpr double rounding_of_range = 1e-9;

void demand_within(const Range& range, const std::vector<double>& values, const std::vector<std::int64_t>& id,
                   const std::string& where) {
  const double slack = rounding_of_range * (range.high - range.low);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] < range.low - slack || values[i] > range.high + slack)
      throw DataError(fmt::format(
          "{}: {} of member {} is {}, outside of its prior, {} to {}; take the set out, or widen the prior", where,
          range.name, id[i], number_text(values[i]), number_text(range.low), number_text(range.high)));
}

std::vector<Round> from_prior(std::size_t sets) { return {{{{}, 1, 1}, sets}}; }

std::vector<Round> read_rounds(const io::Series& table, const Ensemble& members, const std::string& where) {
  std::vector<Round> rounds = rounds_from(table, members.prior.size(), where);
  std::size_t sets = 0;
  for (const Round& round : rounds) sets += round.sets;
  if (sets != members.size())
    throw DataError(fmt::format("{}: tells of {} sets, but there are {}", where, sets, members.size()));
  return rounds;
}

Ensemble from_table(const io::Series& table, Prior prior, const std::string& where) {
  Ensemble e;
  e.prior = std::move(prior);
  e.id = read_ids(table, where);
  const auto rows = static_cast<Eigen::Index>(e.size());
  e.values.resize(rows, static_cast<Eigen::Index>(e.prior.size()));
  for (std::size_t k = 0; k < e.prior.size(); ++k) {
    const Range& range = e.prior.ranges[k];
    const std::vector<double> values = io::in_unit(table, range.name, range.unit, where);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        throw DataError(fmt::format("{}: {} of member {} is not finite", where, range.name, e.id[i]));
    demand_within(range, values, e.id, where);
    e.values.col(static_cast<Eigen::Index>(k)) = vector_of(values);
  }
  e.log_importance = optional_column(table, importance_name, rows, where);
  e.weight = read_weights(table, rows, where);
  if ((e.log_importance.array() == 0).all()) e.rounds = from_prior(e.size());
  return e;
}

Prior spanned(const io::Series& table, const std::string& where) {
  if (table.rows() == 0) throw DataError(where + ": has no rows; give a line for each parameter set");
  Prior prior;
  for (const io::Column& column : table.columns) {
    if (column.name == "id" || column.name == importance_name || column.name == weight_name) continue;
    for (std::size_t r = 0; r < column.values.size(); ++r)
      if (!std::isfinite(column.values[r]))
        throw DataError(fmt::format("{}: row {}: {} is not finite", where, r + 1, column.name));
    const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
    if (!(*low < *high))
      throw DataError(
          fmt::format("{}: {} has one value only: no range to find it in; give --prior", where, column.name));
    prior.ranges.push_back({column.name, column.unit.empty() ? "1" : column.unit, column.name, *low, *high});
  }
  if (prior.ranges.empty()) throw DataError(where + ": has no parameters beside id; give a column for each");
  return prior;
}

/// Returns the columns that differ between sets and belong to no parameter.
std::vector<std::string> unused_columns(const io::Series& table, const Prior& prior) {
  std::vector<std::string> known = prior.names(), unused;
  for (const char* name : {"id", importance_name, weight_name}) known.emplace_back(name);
  for (const io::Column& column : table.columns)
    if (std::ranges::count(known, column.name) == 0 &&
        std::ranges::any_of(column.values, [&](double value) { return value != column.values.front(); }))
      unused.push_back(column.name);
  return unused;
}

}  // namespace

io::Series Ensemble::parameters() const {
  io::Series table;
  for (std::size_t k = 0; k < prior.size(); ++k)
    table.columns.push_back(
        {prior.ranges[k].name, prior.ranges[k].unit, prior.ranges[k].long_name, column_of(values.col(index(k)))});
  return table;
}

Matrix Ensemble::coordinates() const {
  Matrix all(values.rows(), values.cols());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    all.row(i) = prior.coordinates(values.row(i).transpose()).transpose();
  return all;
}

Vector Ensemble::log_prior_weight() const {
  const Vector logs = log_importance.array() - log_importance.maxCoeff();
  return logs.array() - std::log(logs.array().exp().sum());
}

Vector Ensemble::log_weight() const {
  if (!(weight.size() > 0 && weight.sum() > 0))
    throw DataError("--continue: the ensemble has no weights to begin with; give the file that assimilate wrote");
  return weight.array().log() - std::log(weight.sum());
}

Ensemble members_at(const Prior& prior, const Matrix& coordinates, std::int64_t first_id) {
  Ensemble e;
  e.prior = prior;
  e.values.resize(coordinates.rows(), coordinates.cols());
  for (Eigen::Index i = 0; i < coordinates.rows(); ++i) {
    e.id.push_back(first_id + i);
    e.values.row(i) = prior.values(coordinates.row(i).transpose()).transpose();
  }
  e.log_importance = Vector::Zero(coordinates.rows());
  e.rounds = from_prior(e.size());
  return e;
}

io::Series members_table(const Ensemble& ensemble) {
  return table_of(ensemble, (ensemble.log_importance.array() != 0).any());
}

io::EnsembleFile ensemble_file(const Ensemble& ensemble, std::vector<io::FieldsFile::Group> groups) {
  if (!ensemble.rounds.empty())
    groups.push_back({rounds_name, "distribution that the parameter sets were drawn from, one row per Gaussian",
                      rounds_table(ensemble.rounds, ensemble.prior.size())});
  return {table_of(ensemble, true), prior_text(ensemble.prior), std::move(groups), {}};
}

Ensemble read_ensemble(const std::filesystem::path& path, const std::filesystem::path& prior,
                       std::vector<io::Source>& sources) {
  const std::string where = io::input_name(path);
  std::optional<Prior> given;
  if (!prior.empty()) {
    const io::TextFile text = io::read_text(prior, "prior");
    sources.push_back(text.source);
    given = parse_prior(text.text, prior.string());
  }
  if (path != "-" && !io::is_hdf5(path)) {
    const io::TextFile text = io::read_text(path, "ensemble");
    sources.push_back(text.source);
    const io::Series table = io::from_tsv(text.text, where);
    Ensemble members = from_table(table, given ? *given : spanned(table, where), where);
    members.assumed_prior = !given;
    members.unused = unused_columns(table, members.prior);
    return members;
  }
  const io::EnsembleFile file = io::read_ensemble(path);
  sources.push_back(file.source);
  const Prior own = parse_prior(file.prior, where + ": /prior");
  if (given && !same_ranges(*given, own))
    throw DataError(fmt::format(
        "{}: its sets are drawn from {}; --prior {} has {}: leave --prior out, or draw sets from the other prior",
        where, ranges_text(own), prior.string(), ranges_text(*given)));
  Ensemble members = from_table(file.members, own, where);
  members.weighings = weighings_of(file.source.history);
  for (const io::FieldsFile::Group& group : file.groups)
    if (group.name == rounds_name)
      members.rounds = read_rounds(group.table, members, where + ": /fields/" + rounds_name);
  return members;
}

std::vector<Doubt> doubts(const Ensemble& ensemble, bool goes_on) {
  std::vector<Doubt> list;
  if (ensemble.assumed_prior)
    list.push_back({"prior", fmt::format("the table of sets names no prior, so that all values between their least and "
                                         "greatest count as equally likely: {}; give assimilate the prior that they "
                                         "were drawn from, with --prior",
                                         ranges_text(ensemble.prior))});
  if (ensemble.weight.size() > 0 && !goes_on)
    list.push_back({"weights",
                    "the weights that the ensemble has from an earlier test are left out, and this test counts alone; "
                    "give --continue for both to count"});
  return list;
}

}  // namespace soilweave::calibration
