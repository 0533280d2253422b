// The lines of the wrapped soil, each fitted on its own as the thesis fits it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/thesis_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "gws/solution/model.h"

namespace soilweave::gws {
namespace {

/// Returns whether a constant must be positive.
bool is_positive(const Constant& constant) { return constant.parameter.low == 0 && constant.parameter.open; }

/// Fits `line` once its points and constants are there. model(soil, i) is the fitted value for observed[i];
/// ordinate(soil, x) is the line in its figure. Positive constants are searched as their logarithms, since they may be
/// many orders of magnitude from those of `soil`.
void fit_line(Line& line, const Soil& soil, const std::vector<double>& observed,
              const std::function<double(const Soil&, std::size_t)>& model,
              const std::function<double(const Soil&, double)>& ordinate) {
  std::vector<double> start;
  for (const std::string& key : line.constants) {
    const Constant& searched = constant(key);
    line.given.push_back(soil.*searched.field);
    start.push_back(is_positive(searched) ? std::log(line.given.back()) : line.given.back());
  }
  Soil trial = soil;
  const auto set = [&](const double* values) {
    for (std::size_t k = 0; k < line.constants.size(); ++k) {
      const Constant& searched = constant(line.constants[k]);
      trial.*searched.field = is_positive(searched) ? std::exp(values[k]) : values[k];
    }
  };
  line.fit = fit(line.name, observed, start, [&](const double* parameters, double* fitted) {
    set(parameters);
    for (std::size_t i = 0; i < observed.size(); ++i) fitted[i] = model(trial, i);
  });
  set(line.fit.estimates.data());
  for (std::size_t k = 0; k < line.constants.size(); ++k) {
    const Constant& searched = constant(line.constants[k]);
    line.fit.estimates[k] = trial.*searched.field;
    if (is_positive(searched)) line.fit.standard_errors[k] *= trial.*searched.field;
  }
  for (const double x : line.x) line.ordinate.push_back(ordinate(trial, x));
}

/// Fits `line` to the points of its figure.
void fit_line(Line& line, const Soil& soil, const std::function<double(const Soil&, double)>& ordinate) {
  fit_line(
      line, soil, line.y, [&](const Soil& trial, std::size_t i) { return ordinate(trial, line.x[i]); }, ordinate);
}

/// Returns the soil with n and p_c of a straight line through ln q/p over ln p, the start of the search for the failure
/// line. Throws DataError if q/p does not fall, or so little that p_c leaves its range.
Soil falling(Soil soil, const Line& line) {
  const auto count = static_cast<double>(line.x.size());
  double x_mean = 0, y_mean = 0, squares = 0, products = 0, strength = 0;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    x_mean += std::log(line.x[i]) / count;
    y_mean += std::log(line.y[i]) / count;
    strength += line.y[i] / count;
  }
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const double x = std::log(line.x[i]) - x_mean;
    squares += x * x;
    products += x * (std::log(line.y[i]) - y_mean);
  }
  if (!(squares > 0))
    throw DataError(line.name + ": all tests have one pressure; give strengths at two pressures or more");
  soil.n = -products / squares;
  soil.p_c = std::exp(x_mean + (y_mean - std::log(soil.M)) / soil.n);
  if (soil.n > 0 && constant("failure_line.p_c").parameter.contains(soil.p_c)) return soil;
  throw DataError(fmt::format(
      "{}: q/p at failure {} with pressure (n = {:.3g}, p_c = {:.3g} Pa): give tests over a wider range of pressures, "
      "or take one strength for all by --set failure_line.n=0 --set failure_line.M={:.4g} instead of --failure",
      line.name, soil.n > 0 ? "hardly falls" : "does not fall", soil.n, soil.p_c, strength));
}

}  // namespace

Line compression_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points) {
  Line line = started("compression_line", {"C_t", "p_0"}, {"mean_stress", "Pa", "strain_volumetric", "1"});
  for (std::size_t i = 0; i < points.x.size(); ++i) put_point(line, points.x[i], points.y[i], series.size(), i);
  if (points.x.empty())
    for (std::size_t s = 0; s < series.size(); ++s) {
      if (!series[s].from_rest) continue;
      const std::size_t chosen = series[s].contracting.empty() ? contraction(series[s], soil) : series[s].size();
      for (std::size_t i = 0; i < chosen; ++i)
        if (series[s].contracting.empty() || series[s].contracting[i])
          put_point(line, series[s].mean_stress[i], series[s].strain_volumetric[i], s, i);
    }
  fit_line(line, soil, [](const Soil& trial, double p) { return elastic_volumetric(trial, p) / 100; });
  return line;
}

Line failure_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points) {
  Line line = started("failure_line", {"n", "p_c"}, {"mean_stress", "Pa", "failure_obliquity", "1"});
  for (std::size_t i = 0; i < points.x.size(); ++i) put_point(line, points.x[i], points.y[i], series.size(), i);
  if (line.x.size() < 2)
    throw DataError(line.name + ": 1 point for 2 constants; give strengths at two pressures or more");
  fit_line(line, falling(soil, line), [](const Soil& trial, double p) { return failure_obliquity(trial, p); });
  return line;
}

Line near_failure_line(const std::vector<BagSeries>& series, const Soil& soil) {
  Line line = near_failure_points(series, soil);
  fit_line(line, soil,
           [](const Soil& trial, double strain) { return trial.kappa / (100 * strain + trial.lambda) - trial.xi; });
  return line;
}

Line dilatancy_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference) {
  std::vector<Increment> increments;
  Line line = dilatancy_points(series, soil, difference, increments);
  std::vector<double> observed;
  for (const Increment& d : increments) observed.push_back(d.plastic_volumetric);
  fit_line(
      line, soil, observed,
      [&](const Soil& trial, std::size_t i) {
        // Solves d eps_v^p = X d eps_d^p with d eps_d^p = d eps_a^p - d eps_v^p / 3 for d eps_v^p.
        const double X = dilatancy(trial, increments[i].failure_obliquity, increments[i].obliquity);
        return X / (1 + X / 3) * increments[i].plastic_axial;
      },
      [](const Soil& trial, double distance) { return trial.p_1 * distance - trial.p_2; });
  return line;
}

/// Returns E of one bag: least squares of eps_a^p = p* / E, both accumulated.
double young_modulus(const BagSeries& series, const Soil& soil, Difference difference) {
  double stress = 0, strain = 0, squares = 0, products = 0;
  for (std::size_t i = 0; i + 1 < series.size(); ++i) {
    const Increment d = increment(series, i, soil, difference);
    stress += d.generalized_stress;
    strain += d.plastic_axial;
    squares += stress * stress;
    products += stress * strain;
  }
  if (!(products > 0))
    throw DataError("stiffness: " + series.name +
                    ": the plastic axial strain does not grow with the stress; check its columns");
  return squares / products;
}

Line stiffness_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference) {
  Line line = started("stiffness", {"alpha", "beta"}, {"tensile_stiffness", "N/m", "young_modulus", "Pa"});
  line.residual_name = "log_young_modulus";
  line.residual_unit = "1";
  std::vector<double> observed;
  for (std::size_t s = 0; s < series.size(); ++s) {
    if (!series[s].from_rest) continue;
    put_point(line, series[s].stiffness, young_modulus(series[s], soil, difference), s, 0);
    observed.push_back(std::log(line.y.back()));
  }
  const auto ordinate = [](const Soil& trial, double J) { return trial.young_modulus(J); };
  fit_line(
      line, soil, observed, [&](const Soil& trial, std::size_t i) { return std::log(ordinate(trial, line.x[i])); },
      ordinate);
  return line;
}

std::size_t contraction(const BagSeries& series, const Soil& soil) {
  double steepest = 0;
  for (std::size_t i = 0; i + 1 < series.size(); ++i) {
    const auto power = [&](std::size_t k) { return std::pow(series.mean_stress[k] / soil.p_a, soil.m); };
    const double slope = (series.strain_volumetric[i + 1] - series.strain_volumetric[i]) / (power(i + 1) - power(i));
    if (!(slope > 0.5 * steepest)) return i + 1;
    steepest = std::max(steepest, slope);
  }
  return series.size();
}

}  // namespace soilweave::gws
