// Constants of the wrapped soil where no bags were computed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/text/text.h"
#include "core/text/units.h"
#include "gws/laboratory/triaxial_curves.h"
#include "gws/solution/model.h"

namespace soilweave::gws {
namespace {

// E50 of Toyoura sand at e = 0.68 under 0.2 MPa (data/laboratory). It grows with the pressure to the power
// `toyoura_exponent`.
constexpr double toyoura_E50 = 51e6, toyoura_pressure = 200e3, toyoura_exponent = 0.5, toyoura_void_ratio = 0.68;

double obliquity(double angle) { return 6 * std::sin(angle * degree) / (3 - std::sin(angle * degree)); }

/// Axial strain at half of the strength under a confining pressure.
double half_strain(double obliquity, double E50, double pressure) {
  return 3 * obliquity * pressure / (3 - obliquity) / (2 * E50);
}

double void_ratio_function(double e) { return (2.17 - e) * (2.17 - e) / (1 + e); }

constexpr Parameter friction_range{
    "friction_angle", "deg", 15, 60, false, "friction angle at the peak", "sand and gravel have 25 to 50"},
    dilation_range{"dilation_angle", "deg", 0, 30, false, "dilation angle at the peak", "sand has 0 to 20"},
    modulus_range{"E50", "Pa", 1e5, 1e10, false, "secant modulus to half of the strength", "sand has 5 to 200 MPa"};

/// Sets strength, dilation and stiffness of the test from its curves. The dilation is the greatest slope over a tenth
/// of the final strain.
void measure(Triaxial& test, const Curves& curves, const std::string& path) {
  const auto& strain = curves.strain;
  const auto &volumetric = curves.volumetric, &ratio = curves.ratio;
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(ratio) - ratio.begin());
  if (ratio.size() < 5 || !(ratio[peak] > 1))
    throw DataError(path + ": at least 5 rows with a stress_ratio above 1 are needed");
  const double sine = (ratio[peak] - 1) / (ratio[peak] + 1), half = (ratio[peak] + 1) / 2;
  test.friction_angle = std::asin(sine) / degree;
  test.still_rises = peak + 1 == ratio.size();
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
  for (const auto& [value, range] :
       {std::pair(test.friction_angle, friction_range), std::pair(test.dilation_angle, dilation_range),
        std::pair(test.E50, modulus_range)})
    if (!range.contains(value))
      throw DataError(
          fmt::format("{}: its curves give {} = {:.4g} {}; must be {} ({}): check units, signs and pressure", path,
                      range.name, value, range.unit, range_text(range), range.why));
}

/// Returns E50 of Toyoura sand under a pressure, Pa.
double toyoura_modulus(double pressure) {
  return toyoura_E50 * std::pow(pressure / toyoura_pressure, toyoura_exponent);
}

/// Doubts a modulus more than ten times off Toyoura sand's, which a slip of units gives.
void judge_stiffness(Triaxial& test) {
  constexpr double factor = 10;
  const double usual = toyoura_modulus(test.pressure);
  if (test.E50 > factor * usual || test.E50 < usual / factor)
    test.doubts.push_back(
        {"estimated-stiffness", fmt::format("E50 is {:.3g} MPa under {:.4g} kPa, where Toyoura sand has {:.3g} MPa: "
                                            "check its unit, or that of the axial strain it is computed from",
                                            test.E50 / 1e6, test.pressure / 1e3, usual / 1e6)});
}

}  // namespace

Soil estimated(const Triaxial& test) {
  Soil soil;
  const double at_failure = obliquity(test.friction_angle), p = 3 * test.pressure / (3 - at_failure);
  const double modulus = toyoura_modulus(test.pressure);
  const double scale = half_strain(at_failure, test.E50, test.pressure) /
                       half_strain(failure_obliquity(soil, p), modulus, test.pressure);
  const double strength = at_failure / failure_obliquity(soil, p), stiffness = test.E50 / modulus;
  soil.lambda *= scale;
  soil.kappa *= scale * strength;
  // E50 contains elastic and plastic strain, so both are scaled. If only one changed, the strength would be mobilised
  // at another stress, and a softer soil might settle less.
  soil.alpha *= stiffness;
  soil.C_t *= void_ratio_function(toyoura_void_ratio) / void_ratio_function(test.void_ratio) / stiffness;
  soil.M = at_failure - obliquity(test.dilation_angle);
  soil.p_c = p * std::pow(at_failure / soil.M, 1 / soil.n);
  return soil;
}

Triaxial read_estimate(Settings& table, const NamedFiles& files, std::vector<io::Source>& sources) {
  static constexpr Parameter porosity{"void_ratio",         "1", 0.2, 1.5, false, "void ratio before shear",
                                      "sand has 0.4 to 1.1"},
      confined{"pressure", "Pa", 1e3, 1e7, false, "confining pressure of the test", "tests have 10 kPa to 2 MPa"};
  Triaxial test;
  test.void_ratio = table.number(porosity);
  const bool curves = table.has("triaxial");
  test.pressure = table.number(confined, curves ? std::nullopt : std::optional(1e5));  // E50 ~ pressure
  if (curves) {
    const std::string path = files.path("estimate.triaxial", table.text("triaxial")).string();
    if (!table.has("pressure")) return test;
    const Curves read = read_curves(path, test.pressure, sources);
    measure(test, read, path);
    test.doubts = doubts(read, path);
    judge_stiffness(test);
    return test;
  }
  test.friction_angle = table.number(friction_range);
  test.dilation_angle = table.number(dilation_range);
  test.E50 = table.number(modulus_range);
  if (!(test.dilation_angle < test.friction_angle))
    table.mistake("dilation_angle", "is not below the friction angle: check both, 0 is on the safe side");
  judge_stiffness(test);
  return test;
}

void judge_dilation(Settings& table, const Triaxial& test) {
  const Soil toyoura;  // estimated() derives p_c from its n
  const auto p_c = std::ranges::find(constants(), &Soil::p_c, &Constant::field);
  const double at_failure = obliquity(test.friction_angle), p = 3 * test.pressure / (3 - at_failure);
  const double above_M = at_failure * (1 - std::pow(p / p_c->parameter.high, toyoura.n));
  const double most = std::asin(3 * above_M / (6 + above_M)) / degree;
  if (test.dilation_angle > most && test.dilation_angle < test.friction_angle)
    table.mistake(table.has("triaxial") ? "triaxial" : "dilation_angle",
                  fmt::format("a dilation angle of {:.4g} deg is too near to the friction angle of {:.4g} deg: q/p at "
                              "failure would be M at no pressure of a test; take at most {:.1f} deg",
                              test.dilation_angle, test.friction_angle, std::floor(10 * most) / 10));
}

std::string marked(const Triaxial& test) {
  return fmt::format(
      "estimated from phi {:.3g} deg, psi {:.3g} deg, E50 {:.4g} MPa under {:.4g} kPa, e {:.3g}{}: no bags of it were "
      "computed",
      test.friction_angle, test.dilation_angle, test.E50 / 1e6, test.pressure / 1e3, test.void_ratio,
      test.still_rises ? " (the test still rises at its end, so that its strength is at least this)" : "");
}

}  // namespace soilweave::gws
