// The lines of the wrapped soil identified from series.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/units.h"
#include "gws/model.h"

namespace soilweave::gws {
namespace {

const Constant& constant(const std::string& key) {
  return *std::find_if(constants().begin(), constants().end(), [&](const Constant& c) { return c.key() == key; });
}

/// Fits `line` once its points and constants are there; `model` gives the fitted y from a soil whose constants are the
/// parameters.
void fit_line(Line& line, const Soil& soil, const std::function<double(const Soil&, double x)>& model) {
  for (const std::string& key : line.constants) line.given.push_back(soil.*constant(key).field);
  line.fit = fit(line.name, line.y, line.given, [&](const double* parameters, double* fitted) {
    Soil trial = soil;
    for (std::size_t k = 0; k < line.constants.size(); ++k) trial.*constant(line.constants[k]).field = parameters[k];
    for (std::size_t i = 0; i < line.x.size(); ++i) fitted[i] = model(trial, line.x[i]);
  });
}

void put(Line& line, double x, double y, std::size_t series, std::size_t row) {
  line.x.push_back(x);
  line.y.push_back(y);
  line.series.push_back(series);
  line.row.push_back(row);
}

Line compression_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points) {
  Line line{"compression_line",
            {"compression_line.C_t", "compression_line.p_0"},
            {},
            {},
            {},
            {},
            {},
            "mean_stress",
            "Pa",
            "strain_volumetric",
            "1",
            {}};
  for (std::size_t i = 0; i < points.x.size(); ++i) put(line, points.x[i], points.y[i], series.size(), i);
  if (points.x.empty())
    for (std::size_t s = 0; s < series.size(); ++s) {
      const std::size_t chosen = series[s].contracting.empty() ? contraction(series[s], soil) : series[s].size();
      for (std::size_t i = 0; i < chosen; ++i)
        if (series[s].contracting.empty() || series[s].contracting[i])
          put(line, series[s].mean_stress[i], series[s].strain_volumetric[i], s, i);
    }
  fit_line(line, soil, [](const Soil& trial, double p) { return elastic_volumetric(trial, p) / 100; });
  return line;
}

Line failure_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points) {
  Line line{"failure_line",
            {"failure_line.n", "failure_line.p_c"},
            {},
            {},
            {},
            {},
            {},
            "mean_stress",
            "Pa",
            "failure_obliquity",
            "1",
            {}};
  for (std::size_t i = 0; i < points.x.size(); ++i) put(line, points.x[i], points.y[i], series.size(), i);
  fit_line(line, soil, [](const Soil& trial, double p) { return failure_obliquity(trial, p); });
  return line;
}

Line near_failure_line(const std::vector<BagSeries>& series, const Soil& soil) {
  Line line{"near_failure_line",
            {"near_failure_line.kappa", "near_failure_line.lambda", "near_failure_line.xi"},
            {},
            {},
            {},
            {},
            {},
            "strain_deviatoric",
            "1",
            "distance_to_failure",
            "1",
            {}};
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; i < series[s].size(); ++i)
      put(line, series[s].strain_deviatoric(i),
          failure_obliquity(soil, series[s].mean_stress[i]) - series[s].deviatoric_stress[i] / series[s].mean_stress[i],
          s, i);
  fit_line(line, soil,
           [](const Soil& trial, double strain) { return trial.kappa / (100 * strain + trial.lambda) - trial.xi; });
  return line;
}

Line dilatancy_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference) {
  Line line{"dilatancy_line",
            {"dilatancy_line.p_1", "dilatancy_line.p_2"},
            {},
            {},
            {},
            {},
            {},
            "distance_to_failure",
            "1",
            "distance_of_dilation_rate",
            "1",
            {}};
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; i + 1 < series[s].size(); ++i) {
      const Increment d = increment(series[s], i, soil, difference);
      put(line, d.failure_obliquity - d.obliquity, d.failure_obliquity - soil.M - d.dilation_rate, s, i + 1);
    }
  fit_line(line, soil, [](const Soil& trial, double distance) { return trial.p_1 * distance - trial.p_2; });
  return line;
}

/// E of one bag: least squares of dp* = E d eps_a^p.
double young_modulus(const BagSeries& series, const Soil& soil, Difference difference) {
  std::vector<double> stress, strain;
  for (std::size_t i = 0; i + 1 < series.size(); ++i) {
    const Increment d = increment(series, i, soil, difference);
    stress.push_back(d.generalized_stress);
    strain.push_back(d.plastic_axial);
  }
  const Fit found = fit("Young's modulus of " + series.name, stress, {1e6}, [&](const double* E, double* fitted) {
    for (std::size_t i = 0; i < strain.size(); ++i) fitted[i] = *E * strain[i];
  });
  return found.estimates.front();
}

Line stiffness_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference) {
  Line line{"stiffness", {"stiffness.alpha", "stiffness.beta"},
            {},          {},
            {},          {},
            {},          "tensile_stiffness",
            "N/m",       "log_young_modulus",
            "1",         {}};
  for (std::size_t s = 0; s < series.size(); ++s)
    put(line, series[s].stiffness, std::log(young_modulus(series[s], soil, difference)), s, 0);
  fit_line(line, soil, [](const Soil& trial, double J) { return std::log(trial.young_modulus(J)); });
  return line;
}

std::vector<double> in_unit(const io::Series& table, std::string_view name, std::string_view unit) {
  const io::Column& column = table.at(name);
  const double factor = unit_factor(column.unit.empty() ? unit : std::string_view(column.unit), unit);
  std::vector<double> values = column.values;
  for (double& v : values) v *= factor;
  return values;
}

}  // namespace

BagSeries bag_series(const io::Series& table, const std::string& where, double stiffness, bool natural) {
  BagSeries s;
  s.name = where;
  s.strain_axial = in_unit(table, "strain_axial", "1");
  s.strain_volumetric = in_unit(table, "strain_volumetric", "1");
  s.mean_stress = in_unit(table, "mean_stress", "Pa");
  s.deviatoric_stress = in_unit(table, "deviatoric_stress", "Pa");
  s.stiffness = table.find("tensile_stiffness") ? in_unit(table, "tensile_stiffness", "N/m").at(0) : stiffness;
  if (!(s.stiffness > 0))
    throw DataError(fmt::format(
        "{}: no stiffness of the geotextile: give --geotextile for it, or a column tensile_stiffness", where));
  if (const io::Column* flags = table.find("contracting"))
    for (const double v : flags->values) s.contracting.push_back(v != 0);
  std::size_t peak = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!(s.mean_stress[i] > 0))
      throw DataError(
          fmt::format("{}: row {}: mean stress {} Pa; must be above 0, compression", where, i + 1, s.mean_stress[i]));
    if (natural) {
      s.strain_axial[i] = -std::expm1(-s.strain_axial[i]);
      s.strain_volumetric[i] = -std::expm1(-s.strain_volumetric[i]);
    }
    const auto axial = [&](std::size_t k) { return s.mean_stress[k] + 2 * s.deviatoric_stress[k] / 3; };
    if (axial(i) > axial(peak)) peak = i;
  }
  for (auto* column : {&s.strain_axial, &s.strain_volumetric, &s.mean_stress, &s.deviatoric_stress})
    column->resize(peak + 1);
  if (!s.contracting.empty()) s.contracting.resize(peak + 1);
  if (s.size() < 3)
    throw DataError(fmt::format("{}: {} rows up to the greatest axial stress; at least 3 are needed", where, s.size()));
  return s;
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

Increment increment(const BagSeries& series, std::size_t i, const Soil& soil, Difference difference) {
  const auto obliquity = [&](std::size_t k) { return series.deviatoric_stress[k] / series.mean_stress[k]; };
  const auto elastic = [&](std::size_t k) { return elastic_volumetric(soil, series.mean_stress[k]) / 100; };
  const auto sheared = [&](std::size_t k) { return elastic_shear_factor(soil) * obliquity(k) * elastic(k); };
  const std::size_t j = i + 1;
  const double volumetric = series.strain_volumetric[j] - series.strain_volumetric[i] - (elastic(j) - elastic(i));
  const double deviatoric = series.strain_deviatoric(j) - series.strain_deviatoric(i) - (sheared(j) - sheared(i));
  const double dp = series.mean_stress[j] - series.mean_stress[i];
  const double dq = series.deviatoric_stress[j] - series.deviatoric_stress[i];
  const bool central = difference == Difference::central;
  const auto between = [&](double a, double b) { return central ? (a + b) / 2 : b; };
  Increment d;
  d.dilation_rate = -volumetric / deviatoric;
  d.obliquity = between(obliquity(i), obliquity(j));
  d.failure_obliquity =
      between(failure_obliquity(soil, series.mean_stress[i]), failure_obliquity(soil, series.mean_stress[j]));
  const double K_psi = plastic_ratio(dilatancy(soil, d.failure_obliquity, d.obliquity));
  const auto [c_0, c_1] = generalized_stress(soil, K_psi);
  d.generalized_stress = c_0 * dp + c_1 * dq;
  d.plastic_axial = deviatoric + volumetric / 3;
  return d;
}

Identification identify(const std::vector<BagSeries>& series, const SoilFile& soil, const Points& compression,
                        const Points& failure, Difference difference) {
  Identification found;
  found.soil = soil;
  found.soil.scatter.clear();
  const auto add = [&](const auto& line) {
    try {
      found.lines.push_back(line());
    } catch (const DataError& error) {
      found.left_out.emplace_back(error.what());
    }
  };
  if (!series.empty() || !compression.x.empty()) add([&] { return compression_line(series, soil.soil, compression); });
  if (!failure.x.empty()) add([&] { return failure_line(series, soil.soil, failure); });
  if (!series.empty()) {
    add([&] { return near_failure_line(series, soil.soil); });
    add([&] { return dilatancy_line(series, soil.soil, difference); });
    add([&] { return stiffness_line(series, soil.soil, difference); });
  }
  for (const Line& line : found.lines) {
    for (std::size_t k = 0; k < line.constants.size(); ++k)
      found.soil.soil.*constant(line.constants[k]).field = line.fit.estimates[k];
    if (line.fit.freedom > 0)
      found.soil.scatter.push_back({line.constants, line.fit.standard_errors, line.fit.correlation, line.fit.freedom});
  }
  return found;
}

}  // namespace soilweave::gws
