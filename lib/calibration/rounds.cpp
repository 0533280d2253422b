// Densities of rounds, and rounds in tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/rounds.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "calibration/particle_filter.h"
#include "core/error.h"
#include "files/exchange/table.h"

namespace soilweave::calibration {
namespace {

std::string mean_name(Eigen::Index i) { return fmt::format("mean_{}", i); }
std::string root_name(Eigen::Index i, Eigen::Index j) { return fmt::format("root_{}_{}", i, j); }

}  // namespace

double log_density(const Gaussian& gaussian, const Vector& point) {
  const Vector z = gaussian.root.triangularView<Eigen::Lower>().solve(point - gaussian.mean);
  return -0.5 * z.squaredNorm() - gaussian.root.diagonal().array().log().sum() -
         0.5 * static_cast<double>(point.size()) * std::log(2 * std::numbers::pi);
}

double log_parts(const std::vector<Gaussian>& gaussians, const Vector& point, Vector& parts) {
  parts.resize(index(gaussians.size()));
  for (std::size_t k = 0; k < gaussians.size(); ++k)
    parts[index(k)] = std::log(gaussians[k].share) + log_density(gaussians[k], point);
  return log_sum(parts);
}

double CutMixture::log_density(const Vector& point) const {
  if (gaussians.empty()) return 0;
  Vector parts;
  return std::log(prior_share + (1 - prior_share) * std::exp(log_parts(gaussians, point, parts))) - std::log(inside);
}

double log_density(const std::vector<Round>& rounds, const Vector& point) {
  Vector logs(index(rounds.size()));
  double sets = 0;
  for (std::size_t r = 0; r < rounds.size(); ++r) {
    logs[index(r)] = std::log(static_cast<double>(rounds[r].sets)) + rounds[r].from.log_density(point);
    sets += static_cast<double>(rounds[r].sets);
  }
  return log_sum(logs) - std::log(sets);
}

io::Series rounds_table(const std::vector<Round>& rounds, std::size_t dimension) {
  const Eigen::Index d = index(dimension);
  const Gaussian none{0, Vector::Zero(d), Matrix::Zero(d, d)};
  struct Row {
    std::size_t round;
    const Round& of;
    const Gaussian& gaussian;
  };
  std::vector<Row> rows;
  for (const Round& round : rounds) {
    const auto number = static_cast<std::size_t>(&round - rounds.data()) + 1;
    if (round.from.gaussians.empty()) rows.push_back({number, round, none});
    for (const Gaussian& g : round.from.gaussians) rows.push_back({number, round, g});
  }
  io::Series table;
  const auto put = [&](std::string name, std::string long_name, const auto& value) {
    std::vector<double> column;
    for (const Row& row : rows) column.push_back(static_cast<double>(value(row)));
    table.columns.push_back({std::move(name), "1", std::move(long_name), std::move(column)});
  };
  put("round", "number of the round, from 1", [](const Row& row) { return row.round; });
  put("sets", "number of sets drawn in the round", [](const Row& row) { return row.of.sets; });
  put("prior_share", "share of the round's sets drawn from the prior",
      [](const Row& row) { return row.of.from.prior_share; });
  put("inside", "probability that a draw of the round lies within the ranges",
      [](const Row& row) { return row.of.from.inside; });
  put("share", "share of this Gaussian in the mixture", [](const Row& row) { return row.gaussian.share; });
  for (Eigen::Index i = 0; i < d; ++i)
    put(mean_name(i), "mean of this Gaussian, in the prior's coordinates",
        [i](const Row& row) { return row.gaussian.mean[i]; });
  for (Eigen::Index i = 0; i < d; ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      put(root_name(i, j), "entry of the triangular root of this Gaussian's covariance",
          [i, j](const Row& row) { return row.gaussian.root(i, j); });
  return table;
}

std::vector<Round> rounds_from(const io::Series& table, std::size_t dimension, const std::string& where) {
  const Eigen::Index d = index(dimension);
  std::vector<Round> rounds;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto at = [&](const std::string& name) { return table.at(name).values[row]; };
    const double round = at("round"), sets = at("sets"), share = at("share");
    const bool goes_on = round == static_cast<double>(rounds.size()) && share > 0;
    if (!goes_on && round != static_cast<double>(rounds.size() + 1))
      throw DataError(fmt::format("{}: row {}: round {} does not follow the one before", where, row + 1, round));
    if (!(sets >= 1 && sets < 1e15) || !(at("prior_share") >= 0 && at("prior_share") <= 1) ||
        !(at("inside") > 0 && at("inside") <= 1) || !(share >= 0 && share <= 1 + 1e-9))
      throw DataError(fmt::format("{}: row {}: a number of sets or a share that is none", where, row + 1));
    if (!goes_on) rounds.push_back({{{}, at("prior_share"), at("inside")}, static_cast<std::size_t>(sets)});
    if (share == 0) continue;
    Gaussian g{share, Vector(d), Matrix::Zero(d, d)};
    for (Eigen::Index i = 0; i < d; ++i) {
      g.mean[i] = at(mean_name(i));
      for (Eigen::Index j = 0; j <= i; ++j) g.root(i, j) = at(root_name(i, j));
    }
    if (!g.mean.allFinite() || !g.root.allFinite() || !(g.root.diagonal().array() > 0).all())
      throw DataError(fmt::format("{}: row {}: no Gaussian", where, row + 1));
    rounds.back().from.gaussians.push_back(std::move(g));
  }
  return rounds;
}

}  // namespace soilweave::calibration
