// The lines of the wrapped soil from one fit along the paths of all bags.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/path_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/linear_algebra.h"
#include "gws/identification/path_fit.h"
#include "gws/identification/thesis_lines.h"
#include "gws/solution/model.h"

namespace soilweave::gws {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd inverse(const MatrixXd& positive) { return Cholesky(positive).inverted(); }

/// Fills in a line's fit from its estimates, their covariance, and the residuals of `observed`.
void judge(Line& line, const std::vector<double>& estimates, const MatrixXd& covariance, double freedom,
           const std::vector<double>& observed, const std::vector<double>& residuals) {
  Fit& fit = line.fit;
  fit.estimates = estimates;
  fit.freedom = freedom;
  fit.residuals = residuals;
  for (Index i = 0; i < covariance.rows(); ++i) {
    fit.standard_errors.push_back(std::sqrt(covariance(i, i)));
    for (Index j = 0; j < covariance.cols(); ++j)
      fit.correlation.push_back(covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j)));
  }
  summarize(fit, observed, estimates.size());
}

/// Fills in a line's fit from the part of the path fit that concerns its constants.
void judge(Line& line, const PathFit& path, const std::vector<double>& observed, const std::vector<double>& residuals) {
  std::vector<double> estimates;
  std::vector<Index> places;
  for (const std::string& key : line.constants) {
    estimates.push_back(path.soil.*constant(key).field);
    places.push_back(std::find(path.keys.begin(), path.keys.end(), key) - path.keys.begin());
  }
  judge(line, estimates, path.covariance(places, places), path.freedom, observed, residuals);
}

/// Returns the compression line, with the elastic volumetric strain of each row: measured strain less the solution's
/// plastic strain.
Line compression(const std::vector<BagSeries>& series, const PathFit& path) {
  Line line = started("compression_line", {"C_t", "p_0"}, {"mean_stress", "Pa", "strain_volumetric", "1"});
  std::vector<double> residuals;
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; series[s].from_rest && i < series[s].size(); ++i) {
      const auto row = path.residuals[s].row(static_cast<Index>(i));
      const double p = series[s].mean_stress[i], solution = p / std::exp(row[1]);
      const double elastic = elastic_volumetric(path.soil, solution) / 100 + row[2] / 100;
      put_point(line, p, elastic, s, i);
      line.ordinate.push_back(elastic_volumetric(path.soil, p) / 100);
      residuals.push_back(elastic - line.ordinate.back());
    }
  judge(line, path, line.y, residuals);
  return line;
}

Line near_failure(const std::vector<BagSeries>& series, const PathFit& path) {
  Line line = near_failure_points(series, path.soil);
  std::vector<double> residuals;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    line.ordinate.push_back(path.soil.kappa / (100 * line.x[i] + path.soil.lambda) - path.soil.xi);
    residuals.push_back(line.y[i] - line.ordinate.back());
  }
  judge(line, path, line.y, residuals);
  return line;
}

Line dilatancy(const std::vector<BagSeries>& series, const PathFit& path, Difference difference) {
  std::vector<Increment> increments;
  Line line = dilatancy_points(series, path.soil, difference, increments);
  std::vector<double> observed, residuals;
  for (std::size_t k = 0; k < increments.size(); ++k) {
    const MatrixXd& left = path.residuals[line.series[k]];
    const auto row = static_cast<Index>(line.row[k]);
    observed.push_back(increments[k].plastic_volumetric);
    residuals.push_back((left(row, 2) - left(row - 1, 2)) / 100);
    line.ordinate.push_back(path.soil.p_1 * line.x[k] - path.soil.p_2);
  }
  judge(line, path, observed, residuals);
  return line;
}

/// Returns the variance of ln E between bags that the covariance of the estimates does not explain (DerSimonian and
/// Laird 1986). It brings the weighted squares of the residuals to their expectation; 0 if they are smaller.
double scatter_between(const MatrixXd& axes, const VectorXd& log_E, const MatrixXd& covariance) {
  const MatrixXd weight = inverse(covariance);
  const MatrixXd weighted = product(weight, axes), normal = transposed_product(axes, weighted);
  const MatrixXd explained = product(weighted, product(inverse(normal), weighted.transpose()));
  const MatrixXd left = weight - explained;
  const double squares = log_E.dot(product(left, log_E).col(0)),
               freedom = static_cast<double>(log_E.size() - axes.cols());
  return std::max(0.0, (squares - freedom) / left.trace());
}

/// Returns E = alpha J^beta fitted to the bags' moduli. The moduli's errors are correlated, since the bags share the
/// other constants.
Line stiffness(const std::vector<BagSeries>& series, const PathFit& path) {
  Line line = started("stiffness", {"alpha", "beta"}, {"tensile_stiffness", "N/m", "young_modulus", "Pa"});
  line.residual_name = "log_young_modulus";
  line.residual_unit = "1";
  for (std::size_t s = 0; s < series.size(); ++s)
    if (series[s].from_rest) put_point(line, series[s].stiffness, path.modulus[line.x.size()], s, 0);
  const auto n = static_cast<Index>(line.x.size());
  if (n < 2) throw DataError("stiffness: 1 points for 2 constants; give more");
  if (std::ranges::max(line.x) < 1.01 * std::ranges::min(line.x))
    throw DataError("stiffness: all bags have geotextiles of one stiffness; give one of another");
  MatrixXd axes(n, 2);
  VectorXd log_E(n);
  for (Index i = 0; i < n; ++i) {
    axes.row(i) << 1, std::log(line.x[static_cast<std::size_t>(i)] / 1e6);
    log_E[i] = std::log(line.y[static_cast<std::size_t>(i)]);
  }
  const auto shared = static_cast<Index>(path.keys.size());
  const MatrixXd common = path.covariance.block(shared, shared, n, n);
  const double between = n > 2 ? scatter_between(axes, log_E, common) : 0;
  const MatrixXd weight = inverse(common + between * MatrixXd::Identity(n, n));
  const MatrixXd weighted = product(weight, axes);
  MatrixXd covariance = inverse(transposed_product(axes, weighted));
  const MatrixXd found = product(covariance, transposed_product(weighted, log_E));
  const VectorXd left = log_E - product(axes, found).col(0);
  const double alpha = std::exp(found(0));
  covariance.row(0) *= alpha, covariance.col(0) *= alpha;
  // Degrees of freedom of a variance that is the sum of two (Welch and Satterthwaite).
  const double within = common.diagonal().mean(), all = within + between;
  const double inverse = within * within / path.freedom + (n > 2 ? between * between / static_cast<double>(n - 2) : 0);
  for (const double J : line.x) line.ordinate.push_back(alpha * std::pow(J / 1e6, found(1)));
  judge(line, {alpha, found(1)}, covariance, all * all / inverse, {log_E.begin(), log_E.end()},
        {left.begin(), left.end()});
  return line;
}

/// Returns the moduli at which the search begins: as the thesis finds them, or else from the constants.
std::vector<double> first_moduli(const std::vector<BagSeries>& series, const Soil& soil, Difference difference) {
  std::vector<double> found;
  for (const BagSeries& one : series) {
    if (!one.from_rest) continue;
    try {
      found.push_back(young_modulus(one, soil, difference));
    } catch (const DataError&) {
      found.push_back(soil.young_modulus(one.stiffness));
    }
  }
  return found;
}

}  // namespace

std::vector<Line> path_lines(const std::vector<BagSeries>& series, const Soil& start, bool compression_known,
                             Difference difference, std::vector<std::string>& left_out) {
  const PathFit path = fit_paths(series, start, first_moduli(series, start, difference), compression_known);
  std::vector<Line> lines;
  if (!compression_known) lines.push_back(compression(series, path));
  lines.push_back(near_failure(series, path));
  lines.push_back(dilatancy(series, path, difference));
  try {
    lines.push_back(stiffness(series, path));
  } catch (const DataError& error) {
    left_out.emplace_back(error.what());
  }
  return lines;
}

}  // namespace soilweave::gws
