// Constants of the wrapped soil where no bags were computed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/text/units.h"
#include "files/exchange/table.h"
#include "files/files.h"
#include "gws/solution/model.h"

namespace soilweave::gws {
namespace {

// E50 of Toyoura sand at e = 0.68 under 0.2 MPa (data/laboratory), and the exponent of its growth with pressure.
constexpr double toyoura_E50 = 51e6, toyoura_pressure = 200e3, toyoura_exponent = 0.5, toyoura_void_ratio = 0.68;

double obliquity(double angle) { return 6 * std::sin(angle * degree) / (3 - std::sin(angle * degree)); }

/// Axial strain at half of the strength under a confining pressure.
double half_strain(double obliquity, double E50, double pressure) {
  return 3 * obliquity * pressure / (3 - obliquity) / (2 * E50);
}

double void_ratio_function(double e) { return (2.17 - e) * (2.17 - e) / (1 + e); }

/// Strength, dilation and stiffness of a test's curves. The dilation is the greatest slope over a tenth of the strain.
void read_curves(Triaxial& test, const std::string& path) {
  const io::Series table = io::from_tsv(io::read_text(path, "triaxial test").text, path);
  const std::vector<double> strain = io::in_unit(table, "strain_axial", "1", path),
                            volumetric = io::in_unit(table, "strain_volumetric", "1", path),
                            ratio = io::in_unit(table, "stress_ratio", "1", path);
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(ratio) - ratio.begin());
  if (ratio.size() < 5 || !(ratio[peak] > 1))
    throw DataError(path + ": at least 5 rows with a stress_ratio above 1 are needed");
  const double sine = (ratio[peak] - 1) / (ratio[peak] + 1), half = (ratio[peak] + 1) / 2;
  test.friction_angle = std::asin(sine) / degree;
  const auto at =
      static_cast<std::size_t>(std::ranges::find_if(ratio, [&](double r) { return r >= half; }) - ratio.begin());
  const double before = at > 0 ? ratio[at - 1] : 1, first = at > 0 ? strain[at - 1] : 0;
  const double reached = first + (strain[at] - first) * (half - before) / (ratio[at] - before);
  if (!(reached > 0)) throw DataError(path + ": strain_axial does not rise from 0 to half of the strength");
  test.E50 = (half - 1) * test.pressure / reached;
  double steepest = 0;
  for (std::size_t i = 0, j = 0; i < strain.size(); ++i) {
    while (j < strain.size() && strain[j] < strain[i] + 0.1 * strain.back()) ++j;
    if (j < strain.size()) steepest = std::max(steepest, -(volumetric[j] - volumetric[i]) / (strain[j] - strain[i]));
  }
  test.dilation_angle = std::asin(steepest / (2 + steepest)) / degree;
}

}  // namespace

Soil estimated(const Triaxial& test) {
  Soil soil;
  const double at_failure = obliquity(test.friction_angle), p = 3 * test.pressure / (3 - at_failure);
  const double scale =
      half_strain(at_failure, test.E50, test.pressure) /
      half_strain(failure_obliquity(soil, p),
                  toyoura_E50 * std::pow(test.pressure / toyoura_pressure, toyoura_exponent), test.pressure);
  const double strength = at_failure / failure_obliquity(soil, p);
  soil.lambda *= scale;
  soil.kappa *= scale * strength;
  soil.C_t *= void_ratio_function(toyoura_void_ratio) / void_ratio_function(test.void_ratio);
  soil.M = at_failure - obliquity(test.dilation_angle);
  soil.p_c = p * std::pow(at_failure / soil.M, 1 / soil.n);
  return soil;
}

Triaxial read_estimate(Settings& table) {
  static constexpr Parameter friction{
      "friction_angle", "deg", 15, 60, false, "friction angle at the peak", "sand and gravel have 25 to 50"},
      dilation{"dilation_angle", "deg", 0, 30, false, "dilation angle at the peak", "sand has 0 to 20"},
      modulus{"E50", "Pa", 1e5, 1e10, false, "secant modulus to half of the strength", "sand has 5 to 200 MPa"},
      porosity{"void_ratio", "1", 0.2, 1.5, false, "void ratio before shear", "sand has 0.4 to 1.1"},
      confined{"pressure", "Pa", 1e3, 1e7, false, "confining pressure of the test", "tests have 10 kPa to 2 MPa"};
  Triaxial test;
  test.void_ratio = table.number(porosity);
  const bool curves = table.has("triaxial");
  test.pressure = table.number(confined, curves ? std::nullopt : std::optional(1e5));  // E50 is in proportion to it
  if (curves) {
    read_curves(test, table.text("triaxial"));
    return test;
  }
  test.friction_angle = table.number(friction);
  test.dilation_angle = table.number(dilation);
  test.E50 = table.number(modulus);
  if (!(test.dilation_angle < test.friction_angle))
    table.mistake("dilation_angle", "is not below the friction angle: check both, 0 is on the safe side");
  return test;
}

std::string marked(const Triaxial& test) {
  return fmt::format(
      "estimated from phi {:.3g} deg, psi {:.3g} deg, E50 {:.4g} MPa under {:.4g} kPa, e {:.3g}: no bags of it were "
      "computed",
      test.friction_angle, test.dilation_angle, test.E50 / 1e6, test.pressure / 1e3, test.void_ratio);
}

}  // namespace soilweave::gws
