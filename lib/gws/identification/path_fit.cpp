// All constants of the wrapped soil fitted at once: Levenberg-Marquardt along the paths of several bags.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/path_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/linear_algebra.h"
#include "gws/solution/model.h"
#include "gws/solution/path.h"

namespace soilweave::gws {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double difference_step = 1e-5;  // step of a parameter, for numerical derivatives
constexpr double path_tolerance = 1e-9;   // a thousandth of the change by one difference step
constexpr int whitenings = 3;             // the correlation settles after two
constexpr int most_iterations = 100;
constexpr double remaining_gain = 1e-6;  // share of the sum of squares; a hundredth of the errors at a hundred rows

/// A constant as a parameter of the search. Positive constants are searched as logarithms.
struct SearchedConstant {
  const char* key;
  double Soil::*field;
  bool positive;
};
constexpr std::array searched_constants{SearchedConstant{"compression_line.C_t", &Soil::C_t, true},
                                        SearchedConstant{"compression_line.p_0", &Soil::p_0, true},
                                        SearchedConstant{"near_failure_line.kappa", &Soil::kappa, true},
                                        SearchedConstant{"near_failure_line.lambda", &Soil::lambda, true},
                                        SearchedConstant{"near_failure_line.xi", &Soil::xi, false},
                                        SearchedConstant{"dilatancy_line.p_1", &Soil::p_1, false},
                                        SearchedConstant{"dilatancy_line.p_2", &Soil::p_2, false}};

/// Errors of one relation: standard deviation, and correlation between neighbouring rows.
struct Errors {
  double deviation = 1, correlation = 0;
};

class Search {
 public:
  Search(const std::vector<BagSeries>& bags, const Soil& start, const std::vector<double>& modulus,
         bool compression_known)
      : bags_(bags), soil_(start) {
    for (const SearchedConstant& constant : searched_constants)
      if (!compression_known || !std::string_view(constant.key).starts_with("compression")) free_.push_back(&constant);
    shared_ = static_cast<Index>(free_.size());
    Index count = shared_;
    for (const BagSeries& bag : bags) modulus_at_.push_back(bag.from_rest ? count++ : -1);
    at_.resize(count);
    for (Index i = 0; i < shared_; ++i) {
      const double value = start.*free_[static_cast<std::size_t>(i)]->field;
      at_[i] = free_[static_cast<std::size_t>(i)]->positive ? std::log(value) : value;
    }
    for (Index s = shared_; s < count; ++s) at_[s] = std::log(modulus[static_cast<std::size_t>(s - shared_)]);
    for (const BagSeries& bag : bags) rows_ += static_cast<Index>(bag.size());
  }

  PathFit run() {
    if (rows_ <= at_.size())
      throw DataError(fmt::format("{} rows for {} constants; give longer series, or more of them", rows_, at_.size()));
    bool converged = false;
    // Errors are learnt before each search, so the covariance uses the errors that weighted the last search. Errors
    // from the final residuals would be too small where one relation is far more exact than the others.
    for (int k = 0; k < whitenings; ++k) {
      learn_errors(residuals(at_));
      converged = descend();
    }
    if (!converged)
      throw DataError(
          "the search stops before the least sum of squares; check signs and units of the columns, or give --fit "
          "thesis, which searches line by line");
    return result();
  }

 private:
  Soil soil_at(const VectorXd& at) const {
    Soil soil = soil_;
    for (Index i = 0; i < shared_; ++i) {
      const SearchedConstant& constant = *free_[static_cast<std::size_t>(i)];
      soil.*constant.field = constant.positive ? std::exp(at[i]) : at[i];
    }
    return soil;
  }

  /// Returns the residuals of one bag; NaN from the first row that the solution does not reach.
  MatrixXd residuals_of(std::size_t s, const VectorXd& at) const {
    const BagSeries& bag = bags_[s];
    const Soil soil = soil_at(at);
    std::vector<SoilState> states;
    if (bag.from_rest) {
      std::vector<double> strains(bag.strain_axial);
      for (double& strain : strains) strain *= 100;
      states = states_at(soil, std::exp(at[modulus_at_[s]]), strains, path_tolerance);
    }
    MatrixXd found = MatrixXd::Zero(static_cast<Index>(bag.size()), path_relations);
    for (std::size_t i = 0; i < bag.size(); ++i) {
      const double p = bag.mean_stress[i];
      const double line =
          failure_obliquity(soil, p) + soil.xi - soil.kappa / (100 * bag.strain_deviatoric(i) + soil.lambda);
      auto row = found.row(static_cast<Index>(i));
      row[0] = bag.deviatoric_stress[i] / p - line;
      if (!bag.from_rest) continue;
      const bool reached = i < states.size();
      row[1] = reached ? std::log(p / states[i].p) : std::nan("");
      row[2] = reached ? 100 * bag.strain_volumetric[i] - states[i].strain_volumetric : std::nan("");
    }
    return found;
  }

  std::vector<MatrixXd> residuals(const VectorXd& at) const {
    std::vector<MatrixXd> all;
    for (std::size_t s = 0; s < bags_.size(); ++s) all.push_back(residuals_of(s, at));
    return all;
  }

  /// Residuals as independent numbers of unit variance.
  MatrixXd whitened(const MatrixXd& residuals) const {
    MatrixXd white = residuals;
    for (Index b = 0; b < path_relations; ++b) {
      const auto [deviation, r] = errors_[static_cast<std::size_t>(b)];
      for (Index i = residuals.rows() - 1; i > 0; --i) white(i, b) -= r * residuals(i - 1, b);
      white(0, b) *= std::sqrt(1 - r * r);
      white.col(b) /= deviation * std::sqrt(1 - r * r);
    }
    return white;
  }

  double squares(const VectorXd& at) const {
    double sum = 0;
    for (std::size_t s = 0; s < bags_.size(); ++s) sum += whitened(residuals_of(s, at)).squaredNorm();
    return sum;
  }

  /// Standard deviation and correlation of each relation's errors, of all bags together.
  void learn_errors(const std::vector<MatrixXd>& all) {
    for (Index b = 0; b < path_relations; ++b) {
      double squares = 0, products = 0, before = 0, greatest = 0;
      for (const MatrixXd& one : all) {
        const auto column = one.col(b);
        const Index n = column.size();
        squares += column.squaredNorm();
        products += column.head(n - 1).dot(column.tail(n - 1));
        before += column.head(n - 1).squaredNorm();
      }
      greatest = b == 2 ? greatest_volumetric() : 1;  // q/p and ln p are of the order of one
      const double rows = static_cast<double>(rows_), constants = static_cast<double>(at_.size()) / path_relations;
      Errors& errors = errors_[static_cast<std::size_t>(b)];
      errors.deviation = std::max(std::sqrt(squares / (rows - constants)), data_accuracy * greatest);
      const double r = before > 0 ? products / before : 0;
      // A correlation from residuals is too small, by about (1 + 3 r) / n (Marriott and Pope 1954).
      errors.correlation = std::clamp(r + (1 + 3 * r) / rows * static_cast<double>(bags_.size()), 0.0, 0.95);
    }
  }

  double greatest_volumetric() const {
    double greatest = 0;
    for (const BagSeries& bag : bags_)
      for (const double strain : bag.strain_volumetric) greatest = std::max(greatest, 100 * std::abs(strain));
    return greatest;
  }

  /// Whitened residuals and their derivatives, a row for each relation of each row of each bag.
  void linearize(MatrixXd& jacobian, VectorXd& white) const {
    jacobian.setZero(rows_ * path_relations, at_.size());
    white.resize(rows_ * path_relations);
    Index first = 0;
    for (std::size_t s = 0; s < bags_.size(); ++s) {
      const Index n = static_cast<Index>(bags_[s].size()) * path_relations;
      const auto flat = [&](const VectorXd& at) {
        const MatrixXd rows = whitened(residuals_of(s, at)).transpose();
        return VectorXd(Eigen::Map<const VectorXd>(rows.data(), n));
      };
      white.segment(first, n) = flat(at_);
      const auto derive = [&](Index k) {
        VectorXd above = at_, below = at_;
        above[k] += difference_step, below[k] -= difference_step;
        jacobian.block(first, k, n, 1) = (flat(above) - flat(below)) / (2 * difference_step);
      };
      for (Index k = 0; k < shared_; ++k) derive(k);
      if (bags_[s].from_rest) derive(modulus_at_[s]);
      first += n;
    }
  }

  /// Minimises the sum of squares by Levenberg-Marquardt. Returns whether it converged: the next full step would gain
  /// less than a share `remaining_gain` of the sum.
  bool descend() {
    double damping = 1e-3, best = squares(at_);
    if (!std::isfinite(best)) throw ended_early();
    MatrixXd jacobian;
    VectorXd white;
    double promised = 0;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      linearize(jacobian, white);
      if (!jacobian.allFinite()) throw ended_early();
      const MatrixXd normal = transposed_product(jacobian, jacobian);
      const VectorXd slope = transposed_product(jacobian, white);
      promised = slope.dot(solve_semidefinite(normal, slope));
      bool better = false;
      double gain = 0;
      while (!better && damping < 1e12) {
        MatrixXd damped = normal;
        damped.diagonal() *= 1 + damping;
        const VectorXd tried = at_ - Cholesky(damped).solve(slope);
        const double now = squares(tried);
        better = now < best;
        damping *= better ? 0.1 : 10;
        if (!better) continue;
        gain = best - now;
        at_ = tried;
        best = now;
      }
      if (!better || gain < 1e-10 * best) return promised < remaining_gain * best;
      damping = std::max(damping, 1e-12);
    }
    return promised < remaining_gain * best;
  }

  DataError ended_early() const {
    const std::vector<MatrixXd> all = residuals(at_);
    for (std::size_t s = 0; s < bags_.size(); ++s)
      for (Index i = 0; i < all[s].rows(); ++i)
        if (!all[s].row(i).allFinite())
          return DataError(fmt::format(
              "the solution cannot follow {} beyond an axial strain of {:.3g} %; give --fit thesis, which needs none",
              bags_[s].name, 100 * bags_[s].strain_axial[static_cast<std::size_t>(std::max<Index>(i - 1, 0))]));
    return DataError("the solution ends at the bags' last rows; give --fit thesis, which needs none");
  }

  /// Returns the covariance of the parameters from independent errors. Variances are raised to the sandwich estimate,
  /// with rows as clusters, where that is greater.
  MatrixXd covariance() const {
    MatrixXd jacobian;
    VectorXd white;
    linearize(jacobian, white);
    const Index k = at_.size();
    const MatrixXd normal = transposed_product(jacobian, jacobian);
    const VectorXd scale = normal.diagonal().cwiseSqrt();
    if (!(scale.minCoeff() > 0)) throw undetermined();
    const MatrixXd scaled = scale.cwiseInverse().asDiagonal() * normal * scale.cwiseInverse().asDiagonal();
    const Cholesky root(scaled);
    if (!root.positive() || !(root.lower().diagonal().minCoeff() > least_sine)) throw undetermined();
    const MatrixXd plain = scale.cwiseInverse().asDiagonal() * root.inverted() * scale.cwiseInverse().asDiagonal();
    MatrixXd meat = MatrixXd::Zero(k, k);
    for (Index i = 0; i < rows_; ++i) {
      const MatrixXd of = jacobian.middleRows(i * path_relations, path_relations);
      const MatrixXd left =
          MatrixXd::Identity(path_relations, path_relations) - product(of, product(plain, of.transpose()));
      const VectorXd pushed = Cholesky(left).solve(white.segment(i * path_relations, path_relations));
      const VectorXd pull = transposed_product(of, pushed);
      meat += product(pull, pull.transpose());
    }
    const MatrixXd robust = product(product(plain, meat), plain);
    VectorXd wider(k);
    for (Index i = 0; i < k; ++i) wider[i] = std::max(1.0, std::sqrt(robust(i, i) / plain(i, i)));
    return wider.asDiagonal() * plain * wider.asDiagonal();
  }

  DataError undetermined() const {
    return DataError("the rows do not determine the constants; give more bags, or rows over a wider range");
  }

  PathFit result() const {
    PathFit found;
    found.soil = soil_at(at_);
    VectorXd unit = VectorXd::Ones(at_.size());
    for (Index i = 0; i < shared_; ++i) {
      const SearchedConstant& constant = *free_[static_cast<std::size_t>(i)];
      found.keys.emplace_back(constant.key);
      if (constant.positive) unit[i] = found.soil.*constant.field;
    }
    found.covariance = unit.asDiagonal() * covariance() * unit.asDiagonal();
    for (Index s = shared_; s < at_.size(); ++s) found.modulus.push_back(std::exp(at_[s]));
    found.freedom = static_cast<double>(rows_ - at_.size());
    found.residuals = residuals(at_);
    return found;
  }

  const std::vector<BagSeries>& bags_;
  Soil soil_;
  std::vector<const SearchedConstant*> free_;
  std::vector<Index> modulus_at_;  // place of ln E of each bag among the parameters; -1: none
  Index shared_ = 0, rows_ = 0;
  VectorXd at_;  // the constants, positive ones as logarithms; ln E of each bag
  std::array<Errors, path_relations> errors_{};
};

}  // namespace

PathFit fit_paths(const std::vector<BagSeries>& bags, const Soil& start, const std::vector<double>& modulus,
                  bool compression_known) {
  return Search(bags, start, modulus, compression_known).run();
}

}  // namespace soilweave::gws
