// The lines of the wrapped soil identified from series.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identify.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "gws/model.h"
#include "io/table.h"

namespace soilweave::gws {
namespace {

const Constant& constant(const std::string& key) {
  return *std::find_if(constants().begin(), constants().end(), [&](const Constant& c) { return c.key() == key; });
}

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

/// Fits a line whose plotted points are the fitted quantity.
void fit_line(Line& line, const Soil& soil, const std::function<double(const Soil&, double)>& ordinate) {
  fit_line(
      line, soil, line.y, [&](const Soil& trial, std::size_t i) { return ordinate(trial, line.x[i]); }, ordinate);
}

/// Returns a line without points: its constants and the axes of its figure.
Line started(const std::string& name, const std::vector<std::string>& symbols, const std::array<const char*, 4>& axes) {
  Line line;
  line.name = name;
  for (const std::string& symbol : symbols) line.constants.push_back(name + "." + symbol);
  line.x_name = axes[0];
  line.x_unit = axes[1];
  line.residual_name = line.y_name = axes[2];
  line.residual_unit = line.y_unit = axes[3];
  return line;
}

void put(Line& line, double x, double y, std::size_t series, std::size_t row) {
  line.x.push_back(x);
  line.y.push_back(y);
  line.series.push_back(series);
  line.row.push_back(row);
}

Line compression_line(const std::vector<BagSeries>& series, const Soil& soil, const Points& points) {
  Line line = started("compression_line", {"C_t", "p_0"}, {"mean_stress", "Pa", "strain_volumetric", "1"});
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
  Line line = started("failure_line", {"n", "p_c"}, {"mean_stress", "Pa", "failure_obliquity", "1"});
  for (std::size_t i = 0; i < points.x.size(); ++i) put(line, points.x[i], points.y[i], series.size(), i);
  fit_line(line, soil, [](const Soil& trial, double p) { return failure_obliquity(trial, p); });
  return line;
}

Line near_failure_line(const std::vector<BagSeries>& series, const Soil& soil) {
  Line line =
      started("near_failure_line", {"kappa", "lambda", "xi"}, {"strain_deviatoric", "1", "distance_to_failure", "1"});
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; i < series[s].size(); ++i) {
      const double p = series[s].mean_stress[i], obliquity = series[s].deviatoric_stress[i] / p;
      put(line, series[s].strain_deviatoric(i), failure_obliquity(soil, p) - obliquity, s, i);
    }
  fit_line(line, soil,
           [](const Soil& trial, double strain) { return trial.kappa / (100 * strain + trial.lambda) - trial.xi; });
  return line;
}

Line dilatancy_line(const std::vector<BagSeries>& series, const Soil& soil, Difference difference) {
  Line line = started("dilatancy_line", {"p_1", "p_2"}, {"distance_to_failure", "1", "distance_of_dilation_rate", "1"});
  line.residual_name = "plastic_volumetric_increment";
  std::vector<Increment> increments;
  std::vector<double> observed;
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; i + 1 < series[s].size(); ++i) {
      const Increment d = increments.emplace_back(increment(series[s], i, soil, difference));
      observed.push_back(d.plastic_volumetric);
      put(line, d.failure_obliquity - d.obliquity,
          d.failure_obliquity - soil.M + d.plastic_volumetric / d.plastic_deviatoric, s, i + 1);
    }
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

/// Returns E of one bag by least squares of eps_a^p = p* / E, both accumulated.
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
    put(line, series[s].stiffness, young_modulus(series[s], soil, difference), s, 0);
    observed.push_back(std::log(line.y.back()));
  }
  const auto ordinate = [](const Soil& trial, double J) { return trial.young_modulus(J); };
  fit_line(
      line, soil, observed, [&](const Soil& trial, std::size_t i) { return std::log(ordinate(trial, line.x[i])); },
      ordinate);
  return line;
}

}  // namespace

BagSeries bag_series(const io::Series& table, const std::string& where, double stiffness, bool natural,
                     std::size_t first_row) {
  BagSeries s;
  s.name = where;
  s.first_row = first_row;
  const auto column = [&](const char* name, const char* unit) { return io::in_unit(table, name, unit, where); };
  s.strain_axial = column(!table.find("strain_axial") && table.find("strain_zz") ? "strain_zz" : "strain_axial", "1");
  s.strain_volumetric = column("strain_volumetric", "1");
  s.mean_stress = column("mean_stress", "Pa");
  s.deviatoric_stress = column("deviatoric_stress", "Pa");
  if (table.rows() == 0) throw DataError(where + ": has no rows below its header");
  s.stiffness = table.find("tensile_stiffness") ? column("tensile_stiffness", "N/m")[0] : stiffness;
  if (!(s.stiffness > 0))
    throw DataError(fmt::format(
        "{}: no stiffness of the geotextile: give --geotextile for it, or a column tensile_stiffness", where));
  if (const io::Column* flags = table.find("contracting"))
    for (const double v : flags->values) s.contracting.push_back(v != 0);
  std::size_t peak = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!(s.mean_stress[i] > 0))
      throw DataError(fmt::format("{}: row {}: mean stress {} Pa; must be above 0, compression", where,
                                  first_row + i + 1, s.mean_stress[i]));
    if (natural) {
      s.strain_axial[i] = -std::expm1(-s.strain_axial[i]);
      s.strain_volumetric[i] = -std::expm1(-s.strain_volumetric[i]);
    }
    const auto axial = [&](std::size_t k) { return s.mean_stress[k] + 2 * s.deviatoric_stress[k] / 3; };
    if (axial(i) > axial(peak)) peak = i;
  }
  for (auto* values : {&s.strain_axial, &s.strain_volumetric, &s.mean_stress, &s.deviatoric_stress})
    values->resize(peak + 1);
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
  d.plastic_volumetric = volumetric;
  d.plastic_deviatoric = deviatoric;
  d.plastic_axial = deviatoric + volumetric / 3;
  d.obliquity = between(obliquity(i), obliquity(j));
  d.failure_obliquity =
      between(failure_obliquity(soil, series.mean_stress[i]), failure_obliquity(soil, series.mean_stress[j]));
  const double K_psi = plastic_ratio(dilatancy(soil, d.failure_obliquity, d.obliquity));
  const auto [c_0, c_1] = generalized_stress(soil, K_psi);
  d.generalized_stress = c_0 * dp + c_1 * dq;
  return d;
}

Identified range_of(const std::vector<BagSeries>& series) {
  Identified range;
  for (const BagSeries& one : series) {
    range.stiffness.add(one.stiffness);
    for (const double p : one.mean_stress) range.mean_stress.add(p);
    for (const double strain : one.strain_axial) range.axial_strain.add(strain);
  }
  return range;
}

Identification identify(const std::vector<BagSeries>& series, const SoilFile& soil, const Points& compression,
                        const Points& failure, Difference difference) {
  Identification found;
  found.soil = soil;
  found.soil.scatter.clear();
  if (!series.empty()) found.soil.identified = range_of(series);
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
  for (const BagSeries& one : series) {
    auto& list = found.increments.emplace_back();
    for (std::size_t i = 0; i + 1 < one.size(); ++i) list.push_back(increment(one, i, soil.soil, difference));
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
