// Points of the lines of the wrapped soil.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/line.h"

#include <algorithm>

#include "gws/solution/model.h"

namespace soilweave::gws {

const Constant& constant(const std::string& key) {
  return *std::find_if(constants().begin(), constants().end(), [&](const Constant& c) { return c.key() == key; });
}

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

void put_point(Line& line, double x, double y, std::size_t series, std::size_t row) {
  line.x.push_back(x);
  line.y.push_back(y);
  line.series.push_back(series);
  line.row.push_back(row);
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

Line dilatancy_points(const std::vector<BagSeries>& series, const Soil& soil, Difference difference,
                      std::vector<Increment>& increments) {
  Line line = started("dilatancy_line", {"p_1", "p_2"}, {"distance_to_failure", "1", "distance_of_dilation_rate", "1"});
  line.residual_name = "plastic_volumetric_increment";
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; series[s].from_rest && i + 1 < series[s].size(); ++i) {
      const Increment d = increments.emplace_back(increment(series[s], i, soil, difference));
      put_point(line, d.failure_obliquity - d.obliquity,
                d.failure_obliquity - soil.M + d.plastic_volumetric / d.plastic_deviatoric, s, i + 1);
    }
  return line;
}

Line near_failure_points(const std::vector<BagSeries>& series, const Soil& soil) {
  Line line =
      started("near_failure_line", {"kappa", "lambda", "xi"}, {"strain_deviatoric", "1", "distance_to_failure", "1"});
  for (std::size_t s = 0; s < series.size(); ++s)
    for (std::size_t i = 0; i < series[s].size(); ++i) {
      const double p = series[s].mean_stress[i], obliquity = series[s].deviatoric_stress[i] / p;
      put_point(line, series[s].strain_deviatoric(i), failure_obliquity(soil, p) - obliquity, s, i);
    }
  return line;
}

}  // namespace soilweave::gws
