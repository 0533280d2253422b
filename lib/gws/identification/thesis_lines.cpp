// The lines of the wrapped soil, each fitted on its own as the thesis fits it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/thesis_lines.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "gws/solution/model.h"

namespace soilweave::gws {
namespace {

/// Fits `line` once its points and constants are there. model(soil, i) is the fitted value for observed[i];
/// ordinate(soil, x) is the line in its figure.
void fit_line(Line& line, const Soil& soil, const std::vector<double>& observed,
              const std::function<double(const Soil&, std::size_t)>& model,
              const std::function<double(const Soil&, double)>& ordinate) {
  for (const std::string& key : line.constants) line.given.push_back(soil.*constant(key).field);
  Soil trial = soil;
  const auto set = [&](const double* values) {
    for (std::size_t k = 0; k < line.constants.size(); ++k) trial.*constant(line.constants[k]).field = values[k];
  };
  line.fit = fit(line.name, observed, line.given, [&](const double* parameters, double* fitted) {
    set(parameters);
    for (std::size_t i = 0; i < observed.size(); ++i) fitted[i] = model(trial, i);
  });
  set(line.fit.estimates.data());
  for (const double x : line.x) line.ordinate.push_back(ordinate(trial, x));
}

/// Fits `line` where the points of the figure are what is fitted.
void fit_line(Line& line, const Soil& soil, const std::function<double(const Soil&, double)>& ordinate) {
  fit_line(
      line, soil, line.y, [&](const Soil& trial, std::size_t i) { return ordinate(trial, line.x[i]); }, ordinate);
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
  fit_line(line, soil, [](const Soil& trial, double p) { return failure_obliquity(trial, p); });
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
